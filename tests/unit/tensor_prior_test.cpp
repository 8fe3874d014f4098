// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature against its noise: what is known stays, what is not known is not made up.
#include "integral_invariant/multiscale/tensor_prior.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace integral_invariant;

namespace {

/// Of (H, (K_uu − K_vv)/2, K_uv), from independent noise of K_uu, K_vv and K_uv.
Symmetric3 covariance_of(double along, double across, double mixed)
{
  return {(along + across) / 4, (along - across) / 4, 0, (along + across) / 4, 0, mixed};
}

}  // namespace

TEST(Shrinkage, ExactValuesStay)
{
  const PosteriorCurvature s = posterior_curvature({0.3, -0.2, 0.1}, Symmetric3::identity(1e-20));
  EXPECT_NEAR(s.value.x, 0.3, 1e-12);
  EXPECT_NEAR(s.value.y, -0.2, 1e-12);
  EXPECT_NEAR(s.value.z, 0.1, 1e-12);
  EXPECT_LT(s.variance.x, 1e-19);
  EXPECT_EQ(norm(posterior_curvature({}, Symmetric3::identity(0)).value), 0);
}

TEST(Shrinkage, WhatNoiseAloneWouldShowIsAPlane)
{
  const PosteriorCurvature s = posterior_curvature({0.1, -0.1, 0.05}, Symmetric3::identity(0.02));
  EXPECT_EQ(norm(s.value), 0);
  EXPECT_GT(s.variance.x, 0) << "curvature may hide in the noise";
  EXPECT_LT(s.variance.x, 0.02);
}

TEST(Shrinkage, TheBadlyKnownDirectionFollowsTheWellKnownOne)
{
  const double along = 0.023, across = 0.039;
  const PosteriorCurvature s =
      posterior_curvature({(along + across) / 2, (along - across) / 2, 0}, covariance_of(1e-8, 1.2e-3, 1e-4));
  EXPECT_NEAR(s.value.x + s.value.y, along, 1e-4);
  EXPECT_LT(std::abs(s.value.x - s.value.y), across / 4);
}

TEST(Shrinkage, ErrorsAreSmallerAndAsExpected)
{
  std::mt19937 generator(5);
  std::normal_distribution<double> gauss(0, 1);
  for (const double curvature : {0.02, 0.1, 0.5}) {
    const double along = 1e-5, across = 2e-2, mixed = 1e-3;
    double before = 0, after = 0, expected = 0;
    for (int i = 0; i < 20000; ++i) {
      const double uu = curvature * gauss(generator), vv = curvature * gauss(generator),
                   uv = curvature * gauss(generator) / std::sqrt(2);
      const Vec3 truth{(uu + vv) / 2, (uu - vv) / 2, uv};
      const double a = std::sqrt(along) * gauss(generator), c = std::sqrt(across) * gauss(generator);
      const Vec3 noise{(a + c) / 2, (a - c) / 2, std::sqrt(mixed) * gauss(generator)};
      const PosteriorCurvature s = posterior_curvature(truth + noise, covariance_of(along, across, mixed));
      before += squared_norm(noise);
      after += squared_norm(s.value - truth);
      expected += s.variance.x + s.variance.y + s.variance.z;
    }
    EXPECT_LT(after, before) << curvature;
    EXPECT_NEAR(expected / after, 1, 0.5) << curvature;
  }
}
