// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: one triangle and one sphere about the origin, in closed form.
#include "integral_invariant/moments/surface/sphere_clip.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/moments/surface/spherical_moments.h"
#include "integral_invariant/support/pi.h"

namespace integral_invariant {

namespace {

/// ∫1, ∫y, ∫y yᵀ over a plane region, y from the foot of the origin on the plane.
struct PlaneMoments {
  double area = 0;
  Vec3 first;
  Symmetric3 second;
};

/// The circular segment: the sector less the triangle of the foot and the chord.
PlaneMoments plane_segment(const Vec3& n, double squared_radius, const Vec3& y_a, const Vec3& y_b, double turn)
{
  const double triangle = 0.5 * dot(n, cross(y_a, y_b));
  const Vec3 sum = y_a + y_b;
  const Symmetric3 ends = symmetric_outer(y_b, cross(n, y_b)) - symmetric_outer(y_a, cross(n, y_a));
  PlaneMoments m;
  m.area = 0.5 * squared_radius * turn - triangle;
  m.first = cross(y_b - y_a, n) * (squared_radius / 3) - sum * (triangle / 3);
  m.second = (Symmetric3::identity() - outer(n)) * (squared_radius * squared_radius * turn / 8) -
             ends * (squared_radius / 16) - (outer(y_a) + outer(y_b) + outer(sum)) * (triangle / 12);
  return m;
}

/// flux = the cone over the plane region less the ball's sector over the same directions.
SolidMoments flux(const Vec3& n, double h, double r, const PlaneMoments& plane, const SphericalMoments& directions)
{
  const double r3 = r * r * r;
  SolidMoments sums;
  sums.volume = (h * plane.area - r3 * directions.area) / 3;
  sums.first = ((n * (h * plane.area) + plane.first) * h - directions.first * (r3 * r)) * 0.25;
  const Symmetric3 second = outer(n) * (h * h * plane.area) + symmetric_outer(n, plane.first) * h + plane.second;
  sums.second = (second * h - directions.second * (r3 * r * r)) * 0.2;
  return sums;
}

/// Whether the edge from a to b, both outside, dips into the ball, and where.
bool crosses_twice(const Vec3& a, const Vec3& b, double radius, std::array<Vec3, 2>& ends)
{
  const Vec3 e = b - a;
  const double along = -dot(a, e), length2 = squared_norm(e);
  if (!(along > 0 && along < length2)) return false;
  const double excess = squared_norm(a) - radius * radius;
  const double discriminant = along * along - length2 * excess;
  if (!(discriminant > 0)) return false;
  const double root = std::sqrt(discriminant);
  ends = {a + e * (excess / (along + root)), a + e * ((along + root) / length2)};
  return true;
}

bool contains_foot(const std::array<Vec3, 3>& t, const Vec3& n)
{
  for (int i = 0; i < 3; ++i)
    if (dot(n, cross(t[i], t[(i + 1) % 3])) < 0) return false;
  return true;
}

}  // namespace

double edge_crossing(const Vec3& a, const Vec3& b, double radius)
{
  const Vec3 e = b - a;
  const double along = dot(a, e), length2 = squared_norm(e), depth = radius * radius - squared_norm(a);
  // The form of the root that subtracts nothing; the discriminant is positive but for rounding.
  const double q = std::abs(along) + std::sqrt(std::max(0.0, along * along + length2 * depth));
  if (!(q > 0)) return 0;
  return std::min(1.0, depth >= 0 && along < 0 ? q / length2 : std::abs(depth) / q);
}

SolidMoments segment_flux(const Vec3& n, double h, double radius, const Vec3& a, const Vec3& b)
{
  if (h == 0) return {};
  const Vec3 y_a = a - n * h, y_b = b - n * h;
  const double angle = std::atan2(dot(n, cross(y_a, y_b)), dot(y_a, y_b));
  const double turn = angle < 0 ? angle + 2 * pi : angle;
  const double squared_radius = std::max(0.0, radius * radius - h * h);
  return flux(n, h, radius, plane_segment(n, squared_radius, y_a, y_b, turn),
              circle_lens(n, h / radius, a * (1 / radius), b * (1 / radius), turn));
}

SolidMoments disc_flux(const Vec3& n, double h, double radius)
{
  if (h == 0) return {};
  const double squared_radius = std::max(0.0, radius * radius - h * h);
  PlaneMoments disc;
  disc.area = pi * squared_radius;
  disc.second = (Symmetric3::identity() - outer(n)) * (pi / 4 * squared_radius * squared_radius);
  return flux(n, h, radius, disc, circle_cap(n, h / radius));
}

SolidMoments cone_moments(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double det = dot(a, cross(b - a, c - a));
  const Vec3 sum = a + b + c;
  return {det / 6, sum * (det / 24), (outer(a) + outer(b) + outer(c) + outer(sum)) * (det / 120)};
}

SolidMoments curved_excess(const std::array<Vec3, 3>& t, double radius, int lone, bool lone_is_inside,
                           const std::array<Vec3, 2>& chord)
{
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const double length = norm(normal);
  if (!(length > 0)) return {};
  const Vec3 n = normal * (1 / length);
  const double h = dot(n, t[0]);
  if (h == 0 || std::abs(h) >= radius) return {};

  SolidMoments excess;
  if (lone >= 0) {
    excess = lone_is_inside ? segment_flux(n, h, radius, chord[0], chord[1])
                            : segment_flux(n, h, radius, chord[1], chord[0]);
    if (!lone_is_inside) return excess;
  }
  bool dips = false;
  for (int i = 0; i < 3; ++i) {
    std::array<Vec3, 2> ends;
    if (i == lone || (i + 1) % 3 == lone || !crosses_twice(t[i], t[(i + 1) % 3], radius, ends)) continue;
    excess += segment_flux(n, h, radius, ends[0], ends[1]) * -1.0;
    dips = true;
  }
  if (lone < 0 && (dips || contains_foot(t, n))) excess += disc_flux(n, h, radius);
  return excess;
}

}  // namespace integral_invariant
