// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "integral_invariant/mesh/hilbert_curve.h"
#include "integral_invariant/support/execution.h"
#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// A vertex and the cell of the curve that it is in.
struct CurveCell {
  std::uint64_t cell;
  std::uint32_t vertex;
};

/// The vertices that count, along the curve and within a cell by their coordinates (see precedes()).
/// Cost O(n log n), on all workers, and 40 bytes a vertex. \throw Cancelled
std::vector<CurveCell> hilbert_sort(const HilbertCurve& curve, const std::vector<Vec3>& positions,
                                    const std::function<bool(std::size_t vertex)>& counts, Execution& execution);

}  // namespace integral_invariant
