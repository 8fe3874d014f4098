// SPDX-License-Identifier: GPL-3.0-or-later
// The radii of the scales, from the parameters.
#pragma once

#include <vector>

#include "integral_invariant/parameters.h"

namespace integral_invariant {

/// The n radii r_1 < ... < r_n in normalised units (average edge length 1): linear r_i = i·ē by default [Lai09 4.1], or
/// geometric; a single radius when it is fixed. `unit` is ē in the caller's unit, in which the parameters are given.
/// \throw ParameterError where r_min is not under r_max
std::vector<double> scale_radii(const Parameters& parameters, double unit);

}  // namespace integral_invariant
