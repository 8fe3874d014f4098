// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/support/kernel_sum.h"

#include <cmath>
#include <unordered_map>
#include <utility>

#include "integral_invariant/support/buckets.h"

namespace integral_invariant {

namespace {

/// 21 bits a coordinate: grids of up to two million cells along each axis.
constexpr int coordinate_bits = 21;
constexpr std::int64_t coordinate_mask = (std::int64_t(1) << coordinate_bits) - 1;

std::uint64_t key_of(std::int64_t x, std::int64_t y, std::int64_t z)
{
  return std::uint64_t(x & coordinate_mask) << 2 * coordinate_bits |
         std::uint64_t(y & coordinate_mask) << coordinate_bits | std::uint64_t(z & coordinate_mask);
}

/// The key of the cell's corner: the cell's own but one farther along some axes.
std::uint64_t corner_key(std::uint64_t cell, int corner)
{
  const auto coordinate = [&](int place) { return std::int64_t(cell >> place * coordinate_bits) & coordinate_mask; };
  return key_of(coordinate(2) + (corner & 1), coordinate(1) + (corner >> 1 & 1), coordinate(0) + (corner >> 2));
}

/// Numbers from 0 on for keys, in the order in which they come.
class Numbering {
 public:
  std::uint32_t of(std::uint64_t key)
  {
    return numbers_.try_emplace(key, std::uint32_t(numbers_.size())).first->second;
  }
  std::size_t count() const { return numbers_.size(); }

 private:
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
};

}  // namespace

KernelSum::KernelSum(const std::vector<Vec3>& places, double cell, Execution& execution)
{
  const auto scaled = [&](std::size_t v) { return places[v] * (1 / cell); };
  std::vector<std::uint64_t> keys;
  resize_in_steps(keys, places.size(), execution);
  for_each_index(places.size(), execution, [&](std::size_t v) {
    const Vec3 p = scaled(v);
    keys[v] = key_of(std::int64_t(std::floor(p.x)), std::int64_t(std::floor(p.y)), std::int64_t(std::floor(p.z)));
  });
  Numbering cells, nodes;
  std::vector<std::uint32_t> cell_of;
  resize_in_steps(cell_of, places.size(), execution);
  for_each_in_order(places.size(), execution, [&](std::size_t v) {
    if (v > 0 && keys[v] == keys[v - 1]) {
      cell_of[v] = cell_of[v - 1];
      return;
    }
    cell_of[v] = cells.of(keys[v]);
    if (cell_of[v] < cells_.size()) return;
    cells_.emplace_back();
    for (int corner = 0; corner < 8; ++corner) cells_.back().nodes[corner] = nodes.of(corner_key(keys[v], corner));
  });
  node_count_ = nodes.count();

  Buckets<Place> buckets =
      in_buckets<Place>(places.size(), cells_.size(), execution, [&](std::size_t v, const auto& put) {
        const Vec3 p = scaled(v);
        put(cell_of[v],
            Place{{float(p.x - std::floor(p.x)), float(p.y - std::floor(p.y)), float(p.z - std::floor(p.z))},
                  std::uint32_t(v)});
      });
  places_ = std::move(buckets.items);
  for (std::size_t i = 0; i < cells_.size(); ++i) cells_[i].places_end = buckets.ends[i];
}

}  // namespace integral_invariant
