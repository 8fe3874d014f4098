// SPDX-License-Identifier: GPL-3.0-or-later
// Ball moments of a closed polyhedron, by arithmetic that shares nothing with the engines.
#pragma once

#include "integral_invariant/moments/engine.h"

namespace test_support {

/// Moments of (solid ∩ ball) about `centre`: over every triangle T of the closed mesh, near or far, the signed cone
/// from the centre to T clipped by the ball, ∫ h f min(1, (r/|x|)^{d+3}) dA / (d+3). Long double; exact in the radial
/// direction from the foot of the centre on T's plane, adaptive quadrature along T's edges. Cost O(triangles), ~20 µs
/// each.
integral_invariant::BallMoments polyhedron_moments(const integral_invariant::TriangleMesh& mesh,
                                                   const integral_invariant::Vec3& centre, double radius);

/// Largest difference of the moments in units of r³, r⁴, r⁵.
double moment_distance(const integral_invariant::BallMoments& a, const integral_invariant::BallMoments& b,
                       double radius);

}  // namespace test_support
