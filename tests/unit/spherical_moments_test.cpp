// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms on the sphere against quadrature.
#include <gtest/gtest.h>

#include <cmath>

#include "integral_invariant/moments/surface/sphere_clip.h"
#include "integral_invariant/moments/surface/spherical_moments.h"

using namespace integral_invariant;

namespace {

constexpr double pi = 3.14159265358979323846;

void expect_near(const SphericalMoments& a, const SphericalMoments& b, double tolerance)
{
  EXPECT_NEAR(a.area, b.area, tolerance);
  EXPECT_LT(norm(a.first - b.first), tolerance);
  const Symmetric3 d = a.second - b.second;
  for (const double entry : {d.xx, d.xy, d.xz, d.yy, d.yz, d.zz}) EXPECT_NEAR(entry, 0, tolerance);
}

/// Midpoint rule over the plane triangle, projected: ∫ f(x/|x|) h/|x|³ dA.
SphericalMoments projected_triangle(const Vec3& a, const Vec3& b, const Vec3& c, int n)
{
  SphericalMoments m;
  const double det = dot(a, cross(b, c));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * (n - i) - 1; ++j) {
      const int row = j / 2;
      const double third = j % 2 == 0 ? 1.0 / 3 : 2.0 / 3, u = (i + third) / n, v = (row + third) / n;
      const Vec3 x = a * (1 - u - v) + b * u + c * v, w = normalized(x);
      const double weight = det / (2.0 * n * n) / std::pow(squared_norm(x), 1.5);
      m.area += 2 * weight * 0.5;
      m.first += w * weight;
      m.second += outer(w) * weight;
    }
  return m;
}

SphericalMoments triangle_from_arcs(const Vec3& a, const Vec3& b, const Vec3& c)
{
  SphericalMoments m;
  m.area = spherical_triangle_area(a, b, c);
  m.second = Symmetric3::identity(m.area / 3);
  for (const ArcTerms& arc : {great_arc(a, b), great_arc(b, c), great_arc(c, a)}) {
    m.first += arc.first;
    m.second += arc.second;
  }
  return m;
}

}  // namespace

TEST(SphericalMoments, OctantIsKnown)
{
  const SphericalMoments m = triangle_from_arcs({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  EXPECT_NEAR(m.area, pi / 2, 1e-14);
  EXPECT_NEAR(m.first.x, pi / 4, 1e-14);
  EXPECT_NEAR(m.second.xx, pi / 6, 1e-14);
  EXPECT_NEAR(m.second.xy, 1.0 / 3, 1e-14);  // ∫ xy over an octant
}

TEST(SphericalMoments, TriangleAgainstQuadrature)
{
  const Vec3 a = normalized({1, 0.2, 0.1}), b = normalized({0.3, 1, 0.2}), c = normalized({0.1, 0.3, 1});
  expect_near(triangle_from_arcs(a, b, c), projected_triangle(a, b, c, 400), 2e-6);
  const SphericalMoments turned = triangle_from_arcs(a, c, b);
  EXPECT_NEAR(turned.area, -spherical_triangle_area(a, b, c), 1e-15);
}

TEST(SphericalMoments, ArcOverSineHasNoJump)
{
  for (const double t : {1e-12, 9.99e-4, 1.001e-3, 0.2, 0.7, 0.99}) {
    const double angle = 2 * std::asin(std::sqrt(t));
    EXPECT_NEAR(arc_over_sine(t) * std::sin(angle) / angle, 1, 1e-13) << t;
  }
}

TEST(SphericalMoments, LensIsSectorLessTriangle)
{
  // The cap of all x·n > c cut into three sectors is three lenses and the triangle of their corners.
  const Vec3 n = normalized({0.3, -0.5, 0.8}), u = any_orthogonal(n), v = cross(n, u);
  for (const double c : {0.7, 0.05, -0.4}) {
    const double s = std::sqrt(1 - c * c), angle[3] = {0, 1.9, 4.4};
    Vec3 p[3];
    for (int i = 0; i < 3; ++i) p[i] = n * c + (u * std::cos(angle[i]) + v * std::sin(angle[i])) * s;
    SphericalMoments sum = triangle_from_arcs(p[0], p[1], p[2]);
    for (int i = 0; i < 3; ++i) {
      const double turn = i < 2 ? angle[i + 1] - angle[i] : 2 * pi + angle[0] - angle[2];
      const SphericalMoments lens = circle_lens(n, c, p[i], p[(i + 1) % 3], turn);
      sum.area += lens.area;
      sum.first += lens.first;
      sum.second += lens.second;
    }
    expect_near(sum, circle_cap(n, c), 1e-13);
  }
}

TEST(SphereCut, DiscFluxIsCapOfBall)
{
  // The solid below a plane at height h is the half ball of directions plus the disc's flux, for h of either sign.
  for (const double h : {0.3, -0.6}) {
    const double half = 2 * pi / 3, slab = pi * (h - h * h * h / 3), sign = h < 0 ? -1 : 1;
    // A plane seen from inside leaves the whole ball less the cap; flux = −cap for h > 0 and +cap for h < 0.
    const double cap = half - sign * slab;
    EXPECT_NEAR(disc_flux({0, 0, 1}, h, 1).volume, -sign * cap, 1e-14);
  }
}
