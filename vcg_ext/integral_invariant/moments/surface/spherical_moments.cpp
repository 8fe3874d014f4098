// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: closed forms on the unit sphere.
#include "integral_invariant/moments/surface/spherical_moments.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/support/pi.h"

namespace integral_invariant {

namespace {

/// ∫ y yᵀ dφ over the arc of the circle from y_a to y_b (vectors from its centre) through `turn`.
Symmetric3 circle_second(const Vec3& n, const Vec3& y_a, const Vec3& y_b, double turn, double squared_radius)
{
  const Symmetric3 in_plane = Symmetric3::identity() - outer(n);
  const Symmetric3 ends = symmetric_outer(y_b, cross(n, y_b)) - symmetric_outer(y_a, cross(n, y_a));
  return in_plane * (0.5 * squared_radius * turn) - ends * 0.25;
}

/// ∮(ν xᵀ + x νᵀ) ds over the same arc on the sphere: ν ds = (c y − s² n) dφ.
Symmetric3 circle_conormal(const Vec3& n, double c, const Vec3& y_a, const Vec3& y_b, double turn)
{
  const double s2 = 1 - c * c;
  const Vec3 mean = cross(y_b - y_a, n);  // ∫ y dφ
  return symmetric_outer(n, mean) * (c * c - s2) + circle_second(n, y_a, y_b, turn, s2) * (2 * c) -
         outer(n) * (2 * s2 * c * turn);
}

}  // namespace

double spherical_triangle_area(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return 2 * std::atan2(dot(a, cross(b, c)), 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

double arc_over_sine(double t)
{
  if (t < 1e-3) return 1 + t * (2.0 / 3 + t * (8.0 / 15 + t * (16.0 / 35 + t * (128.0 / 315 + t * 256.0 / 693))));
  const double sine = std::sqrt(t), cosine = std::sqrt(1 - t);
  return std::atan2(sine, cosine) / (sine * cosine);
}

ArcTerms great_arc(const Vec3& a, const Vec3& b)
{
  // 1e-30: opposite to the last bit, where the way around is not defined.
  const double t = 0.25 * squared_norm(a - b), squared_cosine = 0.25 * squared_norm(a + b);
  if (squared_cosine < 1e-30) return {};
  const Vec3 normal = cross(a, b);
  const double angle = 2 * std::atan2(std::sqrt(t), std::sqrt(squared_cosine)),
               sine = 2 * std::sqrt(t * squared_cosine);
  const double ratio = t < 1e-3 ? arc_over_sine(t) : angle / sine;
  // −(1/6)(ν wᵀ + w νᵀ) with ν = −a×b/sin θ and w = ∫x ds = tan(θ/2) (a + b).
  return {normal * (0.5 * ratio), symmetric_outer(normal, a + b) * (1 / (12 * squared_cosine))};
}

SphericalMoments circle_lens(const Vec3& n, double c, const Vec3& a, const Vec3& b, double turn)
{
  const double sign = c < 0 ? -1 : 1, s2 = 1 - c * c;
  const Vec3 y_a = a - n * c, y_b = b - n * c;
  const ArcTerms chord = great_arc(a, b);
  SphericalMoments lens;
  lens.area = turn * (sign - c) - spherical_triangle_area(n * sign, a, b);
  lens.first = (n * (s2 * turn) + cross(n, y_b - y_a) * c) * 0.5 - chord.first;
  lens.second = Symmetric3::identity(lens.area / 3) - circle_conormal(n, c, y_a, y_b, turn) * (1.0 / 6) - chord.second;
  return lens;
}

SphericalMoments circle_cap(const Vec3& n, double c)
{
  const double sign = c < 0 ? -1 : 1, s2 = 1 - c * c;
  SphericalMoments cap;
  cap.area = 2 * pi * (sign - c);
  cap.first = n * (pi * s2);
  cap.second = Symmetric3::identity(cap.area / 3) - circle_conormal(n, c, {}, {}, 2 * pi) * (1.0 / 6);
  return cap;
}

}  // namespace integral_invariant
