// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: one triangle and one sphere about the origin, in closed form (docs/surface_engine.md).
//
// What a plane piece U gives to the moments of the ball is the flux of a field that does not pass the sphere,
//   flux(U) = h/(d+3) ∫_U f (1 − (r/|x|)^{d+3}) dA,   f = 1, x, x xᵀ of degree d,   h the plane's signed distance.
// The part of a triangle inside the ball is its corner (cut off by straight chords) and circular segments beyond
// chords.
#pragma once

#include <array>

#include "integral_invariant/moments/solid_moments.h"

namespace integral_invariant {

/// Parameter t in [0, 1] at which a + t (b − a) meets the sphere; one of a, b is inside and the other outside.
double edge_crossing(const Vec3& a, const Vec3& b, double radius);

/// Flux of the circular segment beyond the chord from a to b: the part of the disc {n·x = h, |x| ≤ r} between the chord
/// and the circle from a to b, counter-clockwise about the unit vector n.
SolidMoments segment_flux(const Vec3& n, double h, double radius, const Vec3& a, const Vec3& b);

/// Flux of the whole disc {n·x = h, |x| ≤ r}.
SolidMoments disc_flux(const Vec3& n, double h, double radius);

/// ∫ of 1, x, x xᵀ over the cone from the origin to the triangle.
SolidMoments cone_moments(const Vec3& a, const Vec3& b, const Vec3& c);

/// flux(T∩ball) less that of its straight part: the corner at `lone` (the one vertex that is inside alone, or outside
/// alone). `lone` is 0 to 2, or −1 where all vertices are outside; `chord` are the ends of the corner's chord on the
/// edges lone→next and previous→lone.
SolidMoments curved_excess(const std::array<Vec3, 3>& triangle, double radius, int lone, bool lone_is_inside,
                           const std::array<Vec3, 2>& chord);

}  // namespace integral_invariant
