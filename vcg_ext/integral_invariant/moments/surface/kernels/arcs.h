// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: great arcs between the directions of edges' ends, many at once (rules: clip.h).
#pragma once

#include <array>
#include <cstddef>

#include "integral_invariant/moments/surface/kernels/scale_search.h"
#include "integral_invariant/moments/surface/spherical_region.h"

namespace integral_invariant {

/// Edges in columns, from their first end to their second one; neither end may be the centre.
class ArcBatch {
 public:
  static constexpr std::size_t lanes = kernel_lanes, capacity = 128;

  bool is_full() const { return count_ == capacity; }
  void push(const Vec3& from, const Vec3& to)
  {
    const std::size_t i = count_++;
    column_[0][i] = from.x, column_[1][i] = from.y, column_[2][i] = from.z;
    column_[3][i] = to.x, column_[4][i] = to.y, column_[5][i] = to.z;
  }
  /// Adds the arcs of the edges' directions as seen from `centre`, by the rules of ArcSums, and forgets the edges.
  void add_to(ArcSums& sums, const Vec3& centre, const Vec3& pole);

 private:
  std::size_t count_ = 0;
  alignas(64) std::array<std::array<double, capacity>, 6> column_;
};

}  // namespace integral_invariant
