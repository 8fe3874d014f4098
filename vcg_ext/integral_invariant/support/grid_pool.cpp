// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/support/grid_pool.h"

#include <cmath>
#include <unordered_map>

namespace integral_invariant {

namespace {

/// 21 bits a coordinate: grids of up to two million cells along each axis.
std::uint64_t key_of(std::int64_t x, std::int64_t y, std::int64_t z)
{
  constexpr std::int64_t mask = (std::int64_t(1) << 21) - 1;
  return std::uint64_t(x & mask) << 42 | std::uint64_t(y & mask) << 21 | std::uint64_t(z & mask);
}

}  // namespace

GridPool::GridPool(const std::vector<Vec3>& places, double cell, Execution& execution)
    : corners_(places.size()), fractions_(places.size())
{
  std::unordered_map<std::uint64_t, std::array<std::uint32_t, 8>> cells;
  std::unordered_map<std::uint64_t, std::uint32_t> nodes;
  std::uint64_t last_key = 0;
  for (std::size_t v = 0; v < places.size(); ++v) {
    if (v % check_interval == 0) execution.check();
    const double scaled[3] = {places[v].x / cell, places[v].y / cell, places[v].z / cell};
    std::int64_t base[3];
    for (int axis = 0; axis < 3; ++axis) {
      const double low = std::floor(scaled[axis]);
      base[axis] = std::int64_t(low);
      fractions_[v][axis] = float(scaled[axis] - low);
    }
    const std::uint64_t key_of_cell = key_of(base[0], base[1], base[2]);
    if (v > 0 && key_of_cell == last_key) {
      corners_[v] = corners_[v - 1];
      continue;
    }
    last_key = key_of_cell;
    const auto [it, added] = cells.try_emplace(key_of_cell);
    if (added)
      for (int corner = 0; corner < 8; ++corner) {
        const std::uint64_t key = key_of(base[0] + (corner & 1), base[1] + (corner >> 1 & 1), base[2] + (corner >> 2));
        it->second[corner] = nodes.try_emplace(key, std::uint32_t(nodes.size())).first->second;
      }
    corners_[v] = it->second;
  }
  node_count_ = nodes.size();
}

}  // namespace integral_invariant
