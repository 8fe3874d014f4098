// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: lines without the steps of the mesh.
#pragma once

#include "integral_invariant/drawing/surface_line.h"

namespace integral_invariant {

/// The line with evenly spaced points, each on the quadratic curve of its arc length that fits the line around it with
/// Gaussian weights of the standard deviation `width`: steps shorter than that go, arcs keep their radius. Significance
/// and strength are averaged likewise. Cost: O(length · width / spacing²).
SurfaceLine smoothed_line(const SurfaceLine& line, double width, double spacing);

}  // namespace integral_invariant
