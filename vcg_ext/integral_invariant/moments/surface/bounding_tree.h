// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: a hierarchy of bounding spheres over items that are already sorted in space.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "integral_invariant/support/execution.h"
#include "integral_invariant/vec3.h"

namespace integral_invariant {

struct Sphere {
  Vec3 centre;
  double radius = 0;
};

/// Smallest sphere about the centre of the box of `count` spheres that holds them all.
Sphere bounding_sphere(const Sphere* spheres, std::size_t count);

/// Leaves hold `leaf_size` consecutive items, nodes `fan_out` consecutive nodes of the level below; level 0 are the
/// leaves.
class BoundingTree {
 public:
  static constexpr std::size_t leaf_size = 8, fan_out = 4;

  BoundingTree() = default;
  /// `item_sphere(i)` bounds item i; called from several threads. Cost O(count).
  template <class ItemSphere>
  BoundingTree(std::size_t count, const ItemSphere& item_sphere, Execution& execution) : count_(count)
  {
    levels_.emplace_back((count + leaf_size - 1) / leaf_size);
    parallel_step(levels_[0].size(), 1024, execution, [&](std::size_t begin, std::size_t end, int) {
      std::vector<Sphere> spheres;
      for (std::size_t leaf = begin; leaf < end; ++leaf) {
        spheres.clear();
        for (std::size_t i = item_begin(leaf); i < item_end(leaf); ++i) spheres.push_back(item_sphere(i));
        levels_[0][leaf] = bounding_sphere(spheres.data(), spheres.size());
      }
    });
    while (levels_.back().size() > 1) add_level();
  }

  const std::vector<std::vector<Sphere>>& levels() const { return levels_; }
  std::size_t item_begin(std::size_t leaf) const { return leaf * leaf_size; }
  std::size_t item_end(std::size_t leaf) const { return std::min(count_, (leaf + 1) * leaf_size); }

  /// From the root down: `enter(level, index, sphere)` says whether to go on below; leaves entered go to `leaf(index)`,
  /// in increasing order.
  template <class Enter, class Leaf>
  void visit(Enter&& enter, Leaf&& leaf) const
  {
    if (count_ > 0) visit_node(levels_.size() - 1, 0, enter, leaf);
  }

 private:
  void add_level();

  template <class Enter, class Leaf>
  void visit_node(std::size_t level, std::size_t index, Enter& enter, Leaf& leaf) const
  {
    if (!enter(level, index, levels_[level][index])) return;
    if (level == 0) {
      leaf(index);
      return;
    }
    const std::size_t end = std::min((index + 1) * fan_out, levels_[level - 1].size());
    for (std::size_t child = index * fan_out; child < end; ++child) visit_node(level - 1, child, enter, leaf);
  }

  std::size_t count_ = 0;
  std::vector<std::vector<Sphere>> levels_;
};

}  // namespace integral_invariant
