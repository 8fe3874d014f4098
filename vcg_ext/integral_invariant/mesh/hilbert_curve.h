// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "integral_invariant/support/axes.h"
#include "integral_invariant/support/execution.h"
#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// A Hilbert curve through the cells of a cube: places that follow each other along it are near each other in space.
class HilbertCurve {
 public:
  /// Cells along each axis: 2^bits. Far below an edge of any mesh that fits in memory.
  static constexpr int bits = 20;

  /// Through the cube of the given centre, half side (of any size; 0 and what overflows make a single cell) and axes.
  HilbertCurve(const Vec3& centre, double half_side, const Axes& axes = {});

  /// Place along the curve, in [0, 2^(3 bits)), of the cell that holds each of the points; outside the cube, of the
  /// nearest cell. 25 ns a point, on all workers.
  std::vector<std::uint64_t> indices(const std::vector<Vec3>& points, Execution& execution) const;

 private:
  std::uint32_t cell(double offset) const;

  Axes axes_;
  Vec3 low_;
  double cells_per_length_;
};

}  // namespace integral_invariant
