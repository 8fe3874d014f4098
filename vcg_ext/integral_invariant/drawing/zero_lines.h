// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: the lines along which a function of the vertices is zero, as far as they are significant.
#pragma once

#include <vector>

#include "integral_invariant/drawing/line_scalars.h"
#include "integral_invariant/features/topology.h"

namespace integral_invariant {

/// Which parts of lines are kept.
struct LineSelection {
  double significance = 3;    ///< z that a line has on average over its best piece of the minimum length
  double minimum_length = 5;  ///< ē
};

/// The zeros of `scalar`, linear on each side of a triangle: both triangles of a side see the same zero, so that lines
/// are connected by construction. Kept are the stretches
/// with at least a quarter of the wanted significance (interrupted by at most three segments) that have all of it, on
/// average, over a piece of the minimum length: so lines are drawn to where they fade. Points stand on the fitted
/// surface. Cost: O(m). \throw Cancelled
std::vector<SurfaceLine> zero_lines(const Surface& surface, const Topology& topology, const DifferentiatedField& field,
                                    const LineScalar& scalar, const LineSelection& selection, Execution& execution);

/// The stretches of a line that zero_lines() keeps, from the significance of its points.
void keep_significant(const SurfaceLine& line, const LineSelection& selection, std::vector<SurfaceLine>& kept);

}  // namespace integral_invariant
