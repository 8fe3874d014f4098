// SPDX-License-Identifier: GPL-3.0-or-later
// Points by cubic cells, to find those near a place.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "integral_invariant/vec3.h"

namespace accuracy {

class PointCells {
 public:
  using Vec3 = integral_invariant::Vec3;

  /// Searches are fastest within about `cell` of a place.
  PointCells(std::vector<Vec3> points, double cell) : points_(std::move(points)), cell_(cell)
  {
    for (std::uint32_t i = 0; i < points_.size(); ++i) cells_[key(points_[i])].push_back(i);
  }

  const Vec3& point(std::uint32_t i) const { return points_[i]; }

  /// Calls body(index, squared distance) for every point within `radius` of `p`.
  template <class Body>
  void for_each_within(const Vec3& p, double radius, const Body& body) const
  {
    const Key low = key(p - Vec3{radius, radius, radius}), high = key(p + Vec3{radius, radius, radius});
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y) {
        auto it = cells_.lower_bound({x, y, low[2]});
        for (; it != cells_.end() && !(Key{x, y, high[2]} < it->first); ++it)
          for (const std::uint32_t i : it->second) {
            const double squared = squared_norm(points_[i] - p);
            if (squared <= radius * radius) body(i, squared);
          }
      }
  }

  static constexpr std::uint32_t none = ~std::uint32_t(0);

  /// The nearest point within `radius`, or none.
  std::uint32_t nearest(const Vec3& p, double radius) const
  {
    std::uint32_t best = none;
    double least = INFINITY;
    for_each_within(p, radius, [&](std::uint32_t i, double squared) {
      if (squared >= least) return;
      least = squared;
      best = i;
    });
    return best;
  }

 private:
  using Key = std::array<int, 3>;
  Key key(const Vec3& p) const
  {
    return {int(std::floor(p.x / cell_)), int(std::floor(p.y / cell_)), int(std::floor(p.z / cell_))};
  }

  std::vector<Vec3> points_;
  double cell_;
  std::map<Key, std::vector<std::uint32_t>> cells_;
};

}  // namespace accuracy
