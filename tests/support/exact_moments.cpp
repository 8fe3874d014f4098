// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/exact_moments.h"

namespace test_support {

using namespace integral_invariant;

namespace {

constexpr double pi = 3.14159265358979323846;

}  // namespace

BallMoments half_space_moments(const Vec3& n, double r, double a)
{
  // Slices at height z are discs of squared radius r² − z².
  const double r2 = r * r, r3 = r2 * r, r4 = r2 * r2, r5 = r4 * r, a2 = a * a, a3 = a2 * a, a4 = a3 * a, a5 = a4 * a;
  BallMoments m;
  m.volume = pi * (r2 * (a + r) - (a3 + r3) / 3);
  m.first = n * (pi * (r2 * (a2 - r2) / 2 - (a4 - r4) / 4));
  const double normal2 = pi * (r2 * (a3 + r3) / 3 - (a5 + r5) / 5);
  const double tangent2 = pi / 4 * (r4 * (a + r) - 2 * r2 * (a3 + r3) / 3 + (a5 + r5) / 5);
  m.second = Symmetric3::identity(tangent2) + outer(n) * (normal2 - tangent2);
  return m;
}

BallMoments paraboloid_moments(const Vec3& n, const Vec3& u, double kappa_u, double kappa_v, double r)
{
  BallMoments m = half_space_moments(n, r);
  const double r4 = r * r * r * r, r6 = r4 * r * r;
  // Removed, to first order: the layer of thickness (κ_u u² + κ_v v²)/2 over the disc u² + v² < r².
  const Vec3 v = cross(n, u);
  m.volume -= pi / 8 * r4 * (kappa_u + kappa_v);
  m.second -= (outer(u) * (3 * kappa_u + kappa_v) + outer(v) * (kappa_u + 3 * kappa_v)) * (pi / 48 * r6);
  return m;
}

}  // namespace test_support
