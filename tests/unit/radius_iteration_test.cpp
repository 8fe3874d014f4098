// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/published/radius_iteration.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace integral_invariant;

namespace {

const std::vector<double> radii = {1, 2, 3, 4, 5, 6, 7, 8};

/// One vertex a curvature, the same at all scales, in the direction x of the plane z = 0.
TensorField field_of(const std::vector<double>& curvatures)
{
  TensorField field(curvatures.size(), radii);
  for (std::size_t v = 0; v < curvatures.size(); ++v)
    for (int i = 0; i < 8; ++i) field.set(v, i, {{curvatures[v], 0, 0, 0, 0, 0}, {0, 0, 1}, 1});
  return field;
}

}  // namespace

TEST(FeatureAdapted, ReachesTheFixedPointAlphaOverKappa)
{
  const std::vector<double> curvatures = {0.9, -0.3, 0.2, 0.15};
  Parameters p;
  p.tolerance = 1e-6;
  Execution execution(1);
  const auto adapted = adapt_radii(field_of(curvatures), std::vector<double>(4, 4.5), p, execution);
  EXPECT_EQ(adapted.converged, 4u);
  for (std::size_t v = 0; v < curvatures.size(); ++v) {
    // The last step was under tolerance · r, so the rest of the way is under tolerance · r / step.
    const double fixed_point = p.alpha / std::abs(curvatures[v]);
    EXPECT_NEAR(adapted.radius[v], fixed_point, fixed_point * p.tolerance / p.step * 1.01);
  }
}

TEST(FeatureAdapted, FollowsTheRecurrenceStepByStep)
{
  Parameters p;
  p.max_iterations = 7;
  p.tolerance = 1e-12;
  Execution execution(1);
  const auto adapted = adapt_radii(field_of({0.25}), {8}, p, execution);
  double r = 8;
  for (int i = 0; i < 7; ++i) r += 0.1 * (0.9 / 0.25 - r);
  EXPECT_NEAR(adapted.radius[0], r, 1e-6);  // the field stores single precision
  EXPECT_EQ(adapted.converged, 0u);
  EXPECT_EQ(adapted.largest_iterations, 7);
}

TEST(FeatureAdapted, IsHeldWithinTheScales)
{
  Parameters p;
  p.tolerance = 1e-6;
  Execution execution(1);
  const auto adapted = adapt_radii(field_of({0, 1e-30, 1e30, -50}), std::vector<double>(4, 4.5), p, execution);
  EXPECT_NEAR(adapted.radius[0], 8, 1e-3);
  EXPECT_NEAR(adapted.radius[1], 8, 1e-3);
  EXPECT_NEAR(adapted.radius[2], 1, 1e-3);
  EXPECT_NEAR(adapted.radius[3], 1, 1e-3);
}

TEST(FeatureAdapted, StartIsTheMedianOfTheSmallestPrincipalRadii)
{
  TensorField field(1, radii);
  const double smallest_radii[8] = {7, 3, 5, 2, 6.5, 4, 3.5, 100};
  for (int i = 0; i < 8; ++i) field.set(0, i, {{0, 0, 0, -1 / smallest_radii[i], 0, 0}, {0, 0, 1}, 1});
  Execution execution(1);
  EXPECT_NEAR(start_radii(field, StartRadius::median, execution)[0], 4.5, 1e-6);
  EXPECT_EQ(start_radii(field, StartRadius::middle, execution)[0], 4.5);
  EXPECT_EQ(start_radii(field_of({1e9}), StartRadius::median, execution)[0], 1);
  EXPECT_EQ(start_radii(field_of({0}), StartRadius::median, execution)[0], 8);
}
