// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: lines along edges of the mesh: boundaries and creases.
#pragma once

#include <vector>

#include "integral_invariant/drawing/field_derivative.h"
#include "integral_invariant/drawing/zero_lines.h"

namespace integral_invariant {

/// Boundaries: edges with a triangle on one side. Points stand on the fitted surface. z: as large as can be.
std::vector<SurfaceLine> boundary_lines(const Surface& surface, const Topology& topology,
                                        const DifferentiatedField& field, const LineSelection& selection,
                                        Execution& execution);

/// Creases: edges whose triangles meet at more than `angle` (degrees), concave or convex. z: the angle over its
/// standard error, which noise of the standard deviation `noise` (ē) leaves to two triangles.
std::vector<SurfaceLine> crease_lines(const Surface& surface, const Topology& topology,
                                      const DifferentiatedField& field, double angle, double noise,
                                      const LineSelection& selection, Execution& execution);

}  // namespace integral_invariant
