// SPDX-License-Identifier: GPL-3.0-or-later
// Ball moments in closed form, to feed the stages without an engine.
#pragma once

#include "integral_invariant/moments/engine.h"

namespace test_support {

/// Half space below the plane with that unit normal at height `offset` over the ball's centre (|offset| < r).
integral_invariant::BallMoments half_space_moments(const integral_invariant::Vec3& normal, double radius,
                                                   double offset = 0);

/// Solid y·n < −(κ_u u² + κ_v v²)/2 below an osculating paraboloid at the centre, by the expansion of [Pottmann07] to
/// first order in κ·r: the moments for which the formula of [Yang06] is exact.
integral_invariant::BallMoments paraboloid_moments(const integral_invariant::Vec3& normal,
                                                   const integral_invariant::Vec3& u, double kappa_u, double kappa_v,
                                                   double radius);

}  // namespace test_support
