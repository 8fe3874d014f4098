// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of the surface engine that tests compare.
#pragma once

#include <vector>

#include "integral_invariant/moments/surface/surface_engine.h"

namespace test_support {

/// [vertex][scale]; vertices that no triangle uses keep the default.
using MomentTable = std::vector<std::vector<integral_invariant::BallMoments>>;

MomentTable surface_moments(const integral_invariant::Surface& surface, const std::vector<double>& radii,
                            const integral_invariant::Parameters& parameters = {});

/// Largest κ·r over both curvatures of a ball.
double largest_curvature_times_radius(const integral_invariant::BallMoments& moments, double radius);

}  // namespace test_support
