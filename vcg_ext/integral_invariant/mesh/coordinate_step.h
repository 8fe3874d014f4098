// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// The distance between neighbouring floating-point values at the coordinate of largest magnitude: in single precision
/// where all coordinates fit into it, in double precision otherwise. 0 where there are no points.
double binary_step(const std::vector<Vec3>& points);

/// The same of the precision that the coordinates fill: that of decimal fractions where all are ones of few digits,
/// binary_step() otherwise.
double coordinate_step(const std::vector<Vec3>& points);

}  // namespace integral_invariant
