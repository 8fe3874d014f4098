// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: closed forms on the unit sphere (docs/surface_engine.md, "closed forms").
//
// A region of the sphere enters as its boundary, traversed with the region on the left as seen from outside:
//   ∫ω = ½ ∮ x × dx,   ∫ωωᵀ = (area/3) I − (1/6) ∮ (ν xᵀ + x νᵀ) ds,   ν the outward conormal [Arvo95 for great arcs].
#pragma once

#include "integral_invariant/support/symmetric3.h"
#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// ∫1, ∫ω, ∫ωωᵀ over a signed region of the unit sphere.
struct SphericalMoments {
  double area = 0;
  Vec3 first;
  Symmetric3 second;
};

/// What one arc of the boundary gives. The area is not a sum over arcs; `second` lacks (area/3) I.
struct ArcTerms {
  Vec3 first;
  Symmetric3 second;
};

/// Signed area of the spherical triangle of the unit vectors a, b, c, in (−2π, 2π]: positive when they turn left.
double spherical_triangle_area(const Vec3& a, const Vec3& b, const Vec3& c);

/// θ / sin θ for an arc with sin²(θ/2) = t, 0 ≤ t < 1; relative error about 1e-15.
double arc_over_sine(double t);

/// The shorter great arc from the unit vector a to the unit vector b; zero where they are opposite.
ArcTerms great_arc(const Vec3& a, const Vec3& b);

/// The region between the circle {n·x = c} and the chord of two of its points: bounded by the circle from a to b,
/// counter- clockwise about the unit vector n through the angle `turn` in (0, 2π), and the great arc from b back to a.
/// Positive for c > 0, negative for c < 0 (where the circle turns right as seen from outside).
SphericalMoments circle_lens(const Vec3& n, double c, const Vec3& a, const Vec3& b, double turn);

/// The cap about n that {n·x = c} cuts off (c > 0), or minus the cap about −n (c < 0).
SphericalMoments circle_cap(const Vec3& n, double c);

}  // namespace integral_invariant
