// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: hatching along the lines of curvature.
#pragma once

#include <vector>

#include "integral_invariant/drawing/field_derivative.h"
#include "integral_invariant/drawing/surface_line.h"
#include "integral_invariant/drawing/view.h"

namespace integral_invariant {

/// Evenly spaced lines of minimal and of maximal curvature, `spacing` in the caller's unit. Points on the fitted
/// surface; z is as large as can be, the strength 1 for minimal and 2 for maximal curvature. Cost: that of
/// trace_curvature_lines().
std::vector<SurfaceLine> hatching_lines(const Surface& surface, const DifferentiatedField& field, double spacing,
                                        Execution& execution);

/// What of the hatching is drawn in a view: light comes from the upper left in front; the surface is hatched where it
/// is darker than half, and across too in the deepest shade.
std::vector<SurfaceLine> hatching_in_shade(const std::vector<SurfaceLine>& lines, const View& view,
                                           double minimum_length);

}  // namespace integral_invariant
