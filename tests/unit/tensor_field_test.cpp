// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/ball_curvature/tensor_field.h"

#include <gtest/gtest.h>

#include "integral_invariant/moments/scales.h"
#include "support/exact_moments.h"

using namespace integral_invariant;

namespace {

std::vector<double> ladder(int n, ScaleSpacing spacing, double r_max = 0)
{
  Parameters p = published_method();
  p.scales = n;
  p.spacing = spacing;
  p.r_max = r_max;
  return scale_radii(p, 1);
}

const std::vector<std::vector<double>> ladders = {ladder(1, ScaleSpacing::linear), ladder(2, ScaleSpacing::linear),
                                                  ladder(8, ScaleSpacing::linear), ladder(32, ScaleSpacing::linear),
                                                  ladder(8, ScaleSpacing::geometric, 64)};

}  // namespace

TEST(TensorField, PlaneIsFlatAtEveryRadiusOnAndBetweenTheScales)
{
  const Vec3 n = normalized({0.3, 0.5, 1});
  for (const auto& radii : ladders) {
    TensorField field(1, radii);
    for (int i = 0; i < int(radii.size()); ++i)
      field.set(0, i, curvature_tensor(test_support::half_space_moments(n, radii[i]), radii[i]));
    for (double r = radii.front(); r <= radii.back(); r += 0.01)
      EXPECT_LT(largest_absolute_curvature(field.at_radius(0, r)) * r, 1e-6) << "r = " << r;
  }
}

TEST(TensorField, ReproducesAConstantTensor)
{
  const CurvatureTensor constant{{0.5, 0.25, 0, -0.125, 0, 0}, {0, 0, 1}, 0.75};
  for (const auto& radii : ladders) {
    TensorField field(1, radii);
    for (int i = 0; i < int(radii.size()); ++i) field.set(0, i, constant);
    for (double r = 0.5; r <= radii.back() + 1; r += 0.037) {
      const CurvatureTensor t = field.at_radius(0, r);
      EXPECT_NEAR(t.k.xx, 0.5, 1e-15);
      EXPECT_NEAR(t.k.xy, 0.25, 1e-15);
      EXPECT_NEAR(t.k.yy, -0.125, 1e-15);
      EXPECT_NEAR(t.confidence, 0.75, 1e-15);
    }
  }
}

TEST(TensorField, WeightsAreThoseOfThePaper)
{
  // Tensors that mark their scale show the weights: h_i = exp(−(r − r_i)²/σ²), σ half the gap.
  const std::vector<double> radii = ladder(8, ScaleSpacing::linear);
  for (int marked = 0; marked < 8; ++marked) {
    TensorField field(1, radii);
    field.set(0, marked, {{1, 0, 0, 0, 0, 0}, {0, 0, 1}, 1});
    for (double r = 1; r <= 8; r += 0.1) {
      double sum = 0;
      for (const double ri : radii) sum += std::exp(-4 * (r - ri) * (r - ri));
      const double expected = std::exp(-4 * (r - radii[marked]) * (r - radii[marked])) / sum;
      EXPECT_NEAR(field.at_radius(0, r).k.xx, expected, 2e-7);
    }
  }
}

TEST(TensorField, BlendIsContinuousWhereTheNearestScaleChanges)
{
  const std::vector<double> radii = ladder(8, ScaleSpacing::geometric, 64);
  TensorField field(1, radii);
  for (int i = 0; i < 8; ++i) field.set(0, i, {{double(i % 3), 0, 0, 1, 0, 0}, {0, 0, 1}, 1});
  for (double r = 1; r < 64; r *= 1.001) {
    const double step = field.at_radius(0, r * 1.001).k.xx - field.at_radius(0, r).k.xx;
    EXPECT_LT(std::abs(step), 0.05) << "r = " << r;
  }
}
