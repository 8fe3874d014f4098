// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/ball_curvature/offset_free.h"

#include <gtest/gtest.h>

#include <cmath>

#include "integral_invariant/ball_curvature/ball_bias.h"
#include "support/exact_moments.h"

using namespace integral_invariant;
using test_support::half_space_moments;
using test_support::paraboloid_moments;

namespace {

const Vec3 up = normalized(Vec3{1, 2, 3});
const Vec3 side = any_orthogonal(up);

/// Ball of radius r centred at height `h` over a sphere of radius R: the lens of two balls, by slices across the axis.
BallMoments sphere_moments(const Vec3& n, double big, double h, double r)
{
  BallMoments m;
  constexpr int slices = 200000;
  double normal2 = 0, tangent2 = 0;
  for (int i = 0; i < slices; ++i) {
    const double z = -r + 2 * r * (i + 0.5) / slices, from_centre = z + big + h;
    const double rho2 = std::min(r * r - z * z, big * big - from_centre * from_centre);
    if (rho2 <= 0) continue;
    const double area = pi * rho2 * 2 * r / slices;
    m.volume += area;
    m.first += n * (area * z);
    normal2 += area * z * z;
    tangent2 += area * rho2 / 4;
  }
  m.second = Symmetric3::identity(tangent2) + outer(n) * (normal2 - tangent2);
  return m;
}

/// Cylinder of radius 1 along `axis`, its surface through the ball's centre.
BallMoments cylinder_moments(const Vec3& n, const Vec3& axis, double r)
{
  const Vec3 across = cross(n, axis);
  BallMoments m;
  constexpr int steps = 1200;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double x = -r + 2 * r * (i + 0.5) / steps, z = -r + 2 * r * (j + 0.5) / steps;
      const double half2 = r * r - x * x - z * z;
      if (half2 <= 0 || x * x + (z + 1) * (z + 1) > 1) continue;
      const double half = std::sqrt(half2), area = 4 * r * r / (double(steps) * steps);
      const double length = 2 * half * area;
      m.volume += length;
      m.first += n * (length * z);
      m.second += (outer(across) * (x * x) + outer(n) * (z * z) + outer(axis) * (half2 / 3)) * length;
    }
  return m;
}

double error_at(double r)
{
  const OffsetFreeMeasure measure = offset_free_measure(sphere_moments(up, 1, 0, r), r);
  return std::abs(principal_curvatures(correct_ball_bias(measure.tensor, r, 0, 0)).kappa_max - 1);
}

}  // namespace

TEST(OffsetFree, HalfSpaceOffTheCentreIsFlatAndItsOffsetIsFound)
{
  for (const double offset : {-0.02, 0.0, 0.02}) {
    const double r = 2;
    const OffsetFreeMeasure measure = offset_free_measure(half_space_moments(up, r, offset), r);
    const PrincipalCurvatures k = principal_curvatures(measure.tensor);
    // What is left is of third order in δ/r: 4 δ³/r⁴.
    EXPECT_NEAR(k.kappa_max * r, 0, 5 * std::pow(std::abs(offset) / r, 3) + 1e-12);
    EXPECT_NEAR(k.kappa_min * r, 0, 5 * std::pow(std::abs(offset) / r, 3) + 1e-12);
    EXPECT_NEAR(measure.offset, offset, 1e-5);
    EXPECT_NEAR(dot(measure.tensor.normal, up), 1, 1e-12);
  }
}

TEST(OffsetFree, LargeOffsetOfAHalfSpaceIsCorrectedToThirdOrder)
{
  const double r = 2, offset = 0.2;
  const OffsetFreeMeasure measure = offset_free_measure(half_space_moments(up, r, offset), r);
  const CurvatureTensor corrected = correct_ball_bias(measure.tensor, r, offset, 0);
  EXPECT_LT(std::abs(principal_curvatures(corrected).kappa_max),
            std::abs(principal_curvatures(measure.tensor).kappa_max) / 4);
}

TEST(OffsetFree, ParaboloidIsExactToFirstOrder)
{
  const double r = 0.5;
  const PrincipalCurvatures k =
      principal_curvatures(offset_free_measure(paraboloid_moments(up, side, 0.02, -0.01, r), r).tensor);
  EXPECT_NEAR(k.kappa_max, 0.02, 2e-6);
  EXPECT_NEAR(k.kappa_min, -0.01, 2e-6);
  EXPECT_NEAR(std::abs(dot(k.dir_max, side)), 1, 1e-6);
}

TEST(OffsetFree, VertexNoiseThatMisleadsThePublishedFormulaDoesNotMatter)
{
  const double r = 0.4, height = 0.01;
  const BallMoments moments = sphere_moments(up, 1, height, r);
  const double published = principal_curvatures(curvature_tensor(moments, r)).kappa_max;
  const OffsetFreeMeasure measure = offset_free_measure(moments, r);
  EXPECT_GT(std::abs(published - 1), 2.5 * height / (r * r));
  EXPECT_NEAR(principal_curvatures(correct_ball_bias(measure.tensor, r, measure.offset, 0)).kappa_max, 1, 0.03);
  EXPECT_NEAR(measure.offset, -height, 0.003);  // κ³r⁴ enters
}

TEST(OffsetFree, NothingAndEverythingHaveNoCurvature)
{
  EXPECT_EQ(offset_free_measure({}, 1).tensor.confidence, 0);
  BallMoments full;
  full.volume = 4 * pi / 3;
  full.second = Symmetric3::identity(4 * pi / 15);
  EXPECT_EQ(offset_free_measure(full, 1).tensor.confidence, 0);
}

TEST(OwnBias, OnASphereTheErrorFallsWithTheFourthPower)
{
  const double ratio = error_at(0.8) / error_at(0.4);
  EXPECT_GT(ratio, 10);
  EXPECT_LT(ratio, 25);
  EXPECT_LT(error_at(0.4), 0.005);
}

TEST(OwnBias, OnACylinderBothCurvaturesAreCorrected)
{
  const double r = 0.5;
  const Vec3 axis = side;
  const CurvatureTensor measured = offset_free_measure(cylinder_moments(up, axis, r), r).tensor;
  const PrincipalCurvatures before = principal_curvatures(measured);
  const PrincipalCurvatures after = principal_curvatures(correct_ball_bias(measured, r, 0, 0));
  // −κ³r² (1/16 + 3/128) and −κ³r² (1/16 − 3/128).
  EXPECT_NEAR(before.kappa_max - 1, -r * r * 11 / 128, 0.004);
  EXPECT_NEAR(before.kappa_min, -r * r * 5 / 128, 0.004);
  EXPECT_NEAR(after.kappa_max, 1, 0.004);
  EXPECT_NEAR(after.kappa_min, 0, 0.004);
}

TEST(Extrapolation, RemovesAnErrorThatGrowsWithTheSquareOfTheRadius)
{
  const std::vector<double> radii{1, 1.5, 2.5, 4};
  TensorField tensors(1, radii);
  const Symmetric3 truth{0.3, 0.1, 0, -0.2, 0, 0}, slope{0.01, -0.02, 0, 0.03, 0, 0};
  for (int i = 0; i < 4; ++i) tensors.set(0, i, {truth + slope * (radii[i] * radii[i]), {0, 0, 1}, 1});
  Execution execution(1);
  execution.begin_stage("test", 100);
  extrapolate_to_zero_radius(tensors, execution);
  for (int i = 1; i < 4; ++i) {
    EXPECT_NEAR(tensors.at_scale(0, i).k.xx, truth.xx, 1e-6);
    EXPECT_NEAR(tensors.at_scale(0, i).k.xy, truth.xy, 1e-6);
    EXPECT_NEAR(tensors.at_scale(0, i).k.yy, truth.yy, 1e-6);
  }
}
