// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/ball_curvature/curvature_tensor.h"

#include <gtest/gtest.h>

#include "support/exact_moments.h"
#include "support/shapes.h"

using namespace integral_invariant;
using test_support::half_space_moments;
using test_support::paraboloid_moments;

namespace {

const Vec3 n = normalized({1, -2, 0.5});
const Vec3 u = any_orthogonal(n);
constexpr double pi = 3.14159265358979323846;

/// Sphere of radius R seen from its surface: the lens of two balls, by slices along the axis.
BallMoments sphere_moments(double sphere_radius, double r)
{
  BallMoments m;
  const int slices = 20000;
  const double top = 0, bottom = -r;
  double normal2 = 0, tangent2 = 0, first = 0;
  for (int i = 0; i < slices; ++i) {
    const double z = bottom + (top - bottom) * (i + 0.5) / slices, dz = (top - bottom) / slices;
    const double in_ball = r * r - z * z, in_sphere = -z * (2 * sphere_radius + z);
    const double rho2 = std::max(0.0, std::min(in_ball, in_sphere));
    m.volume += pi * rho2 * dz;
    first += pi * rho2 * z * dz;
    normal2 += pi * rho2 * z * z * dz;
    tangent2 += pi * rho2 * rho2 / 4 * dz;
  }
  m.first = n * first;
  m.second = Symmetric3::identity(tangent2) + outer(n) * (normal2 - tangent2);
  return m;
}

}  // namespace

TEST(CurvatureTensor, PlaneIsFlat)
{
  for (const double r : {1e-3, 1.0, 1e3}) {
    const CurvatureTensor t = curvature_tensor(half_space_moments(n, r), r);
    EXPECT_LT(largest_absolute_curvature(t) * r, 1e-13);
    EXPECT_NEAR(dot(t.normal, n), 1, 1e-14);
  }
}

TEST(CurvatureTensor, RecoversParaboloidsOfEverySign)
{
  const double curvatures[][2] = {{0.03, 0.01}, {0.02, 0.02}, {0.01, -0.03}, {-0.01, -0.04}, {0.05, 0}};
  for (const auto& [ku, kv] : curvatures) {
    const PrincipalCurvatures p = principal_curvatures(curvature_tensor(paraboloid_moments(n, u, ku, kv, 1), 1));
    EXPECT_NEAR(p.kappa_max, std::max(ku, kv), 1e-12);
    EXPECT_NEAR(p.kappa_min, std::min(ku, kv), 1e-12);
    if (ku > kv) { EXPECT_NEAR(std::abs(dot(p.dir_max, u)), 1, 1e-12); }
    EXPECT_NEAR(norm(p.dir_max), 1, 1e-14);
    EXPECT_NEAR(norm(p.dir_min), 1, 1e-14);
    EXPECT_NEAR(dot(p.dir_max, p.dir_min), 0, 1e-14);
    EXPECT_NEAR(dot(p.dir_max, n), 0, 1e-12);
  }
}

TEST(CurvatureTensor, SphereBiasFallsWithTheSquareOfTheRadius)
{
  // [Yang06] on a sphere: the relative error is O((κr)²); halving r must quarter it.
  const auto error = [](double r) { return curvature_tensor(sphere_moments(1, r), r).k.trace() / 2 - 1; };
  EXPECT_NEAR(error(0.4) / error(0.2), 4, 0.35);
  EXPECT_LT(std::abs(error(0.1)), 1e-3);
}

TEST(CurvatureTensor, CavityIsNegative)
{
  // The complement of a ball's lens: V' = 4π/3 r³ − V and so on, seen from inside a spherical hole.
  const double r = 0.2;
  const BallMoments solid = sphere_moments(1, r);
  BallMoments cavity{4 * pi / 3 * r * r * r - solid.volume, -solid.first,
                     Symmetric3::identity(4 * pi / 15 * std::pow(r, 5)) - solid.second, 1};
  const PrincipalCurvatures p = principal_curvatures(curvature_tensor(cavity, r));
  EXPECT_NEAR(p.kappa_max, -1, 0.01);
  EXPECT_NEAR(p.kappa_min, -1, 0.01);
}

TEST(CurvatureTensor, NothingAndEverythingHaveNoCurvature)
{
  for (const BallMoments& m : {BallMoments{}, BallMoments{4 * pi / 3, {}, Symmetric3::identity(4 * pi / 15), 1}}) {
    const CurvatureTensor t = curvature_tensor(m, 1);
    EXPECT_EQ(largest_absolute_curvature(t), 0);
    EXPECT_EQ(t.confidence, 0);
    const PrincipalCurvatures p = principal_curvatures(t);
    EXPECT_NEAR(norm(p.dir_max), 1, 1e-15);
    EXPECT_NEAR(norm(p.dir_min), 1, 1e-15);
  }
}

TEST(PrincipalCurvatures, LargestAbsoluteAgreesWithTheValuesEvenWhereTheTensorLeavesThePlane)
{
  CurvatureTensor t{{0.3, -0.1, 0.2, -0.5, 0.4, 0.1}, n, 1};
  const PrincipalCurvatures p = principal_curvatures(t);
  EXPECT_NEAR(largest_absolute_curvature(t), std::max(std::abs(p.kappa_max), std::abs(p.kappa_min)), 1e-14);
}

TEST(CurvatureTensor, BallAlmostEmptyHasNoDirection)
{
  BallMoments speck;
  speck.volume = 1e-310;
  speck.first = {1e-310, 0, 0};
  const CurvatureTensor t = curvature_tensor(speck, 1);
  EXPECT_EQ(largest_absolute_curvature(t), 0);
  EXPECT_EQ(t.confidence, 0);
}
