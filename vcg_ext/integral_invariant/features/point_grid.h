// SPDX-License-Identifier: GPL-3.0-or-later
// Features: points of lines in cells of space, to find those near a place.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// A point on a line that lies on the surface.
struct LineSample {
  Vec3 position, normal;
  std::int32_t line = 0;
  double arc = 0;  ///< place along the line
};

class PointGrid {
 public:
  /// `cell`: the largest distance that will be asked for.
  explicit PointGrid(double cell) : cell_(cell) {}

  void add(const LineSample& sample) { cells_[key(sample.position)].push_back(sample); }

  /// Takes out the sample at `position` that was added last of all in its cell.
  void take_back(const Vec3& position)
  {
    const auto cell = cells_.find(key(position));
    cell->second.pop_back();
    if (cell->second.empty()) cells_.erase(cell);
  }

  /// Calls visit(sample) for the samples nearer than `distance` on the same side of the surface, until it returns true;
  /// whether it did.
  template <class Visit>
  bool any_near(const Vec3& position, const Vec3& normal, double distance, const Visit& visit) const
  {
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz) {
          const auto cell = cells_.find(key(position + Vec3{double(dx), double(dy), double(dz)} * cell_));
          if (cell == cells_.end()) continue;
          for (const LineSample& sample : cell->second)
            if (squared_norm(sample.position - position) < distance * distance && dot(sample.normal, normal) > 0 &&
                visit(sample))
              return true;
        }
    return false;
  }

 private:
  /// 21 bits an axis; what wraps around is told apart by its distance.
  std::uint64_t key(const Vec3& p) const
  {
    const auto part = [&](double x) { return std::uint64_t(std::int64_t(std::floor(x / cell_))) & 0x1fffff; };
    return part(p.x) << 42 | part(p.y) << 21 | part(p.z);
  }

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<LineSample>> cells_;
};

}  // namespace integral_invariant
