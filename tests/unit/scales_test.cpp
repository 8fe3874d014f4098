// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/moments/scales.h"

#include <gtest/gtest.h>

#include <cmath>

#include "integral_invariant/error.h"

using namespace integral_invariant;

namespace {

constexpr double edge = 0.25;  // average edge length in the caller's unit

}  // namespace

TEST(Scales, AutomaticRadiiAreMultiplesOfTheAverageEdge)
{
  const std::vector<double> radii = scale_radii(published_method(), edge);
  ASSERT_EQ(radii.size(), 8u);
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(radii[i], i + 1, 1e-15);
}

TEST(Scales, StatisticalRadiiAreGeometricAndReachFar)
{
  const std::vector<double> radii = scale_radii({}, edge);
  ASSERT_EQ(radii.size(), 7u);
  EXPECT_NEAR(radii.front(), 1.5, 1e-12);
  EXPECT_NEAR(radii.back(), 16, 1e-12);
  for (int i = 2; i < 7; ++i) EXPECT_NEAR(radii[i] / radii[i - 1], radii[1] / radii[0], 1e-12);
}

TEST(Scales, GeometricRadiiHaveAConstantRatio)
{
  Parameters p = published_method();
  p.spacing = ScaleSpacing::geometric;
  p.r_min = 2 * edge;
  p.r_max = 64 * edge;
  p.scales = 6;
  const std::vector<double> radii = scale_radii(p, edge);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(radii[i], 2 * std::pow(2, i), 1e-12);
}

TEST(Scales, LargeSmallestRadiusMovesTheLadderUp)
{
  Parameters p = published_method();
  p.r_min = 10 * edge;
  const std::vector<double> radii = scale_radii(p, edge);
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(radii[i], 10 * (i + 1), 1e-12);
}

TEST(Scales, OneScaleAndFixedRadius)
{
  Parameters p = published_method();
  p.scales = 1;
  EXPECT_EQ(scale_radii(p, edge), std::vector<double>{1});
  p = published_method();
  p.radius_choice = RadiusChoice::fixed;
  EXPECT_EQ(scale_radii(p, edge), std::vector<double>{4.5});
  p.radius = 3 * edge;
  EXPECT_EQ(scale_radii(p, edge), std::vector<double>{3});
}

TEST(Scales, SmallestMustBeUnderTheLargest)
{
  Parameters p = published_method();
  p.r_min = 2;
  p.r_max = 1;
  try {
    scale_radii(p, edge);
    FAIL();
  } catch (const ParameterError& e) {
    EXPECT_NE(std::string(e.what()).find("r_min is 2 and r_max is 1"), std::string::npos) << e.what();
  }
}

TEST(Scales, RadiiThatCannotBeComputedAreRefusedByName)
{
  const auto refusal = [](double r_min, double r_max, int scales, RadiusChoice choice = RadiusChoice::feature_adapted) {
    Parameters p = published_method();
    p.radius_choice = choice;
    p.r_min = p.radius = r_min * edge;
    p.r_max = r_max * edge;
    p.scales = scales;
    try {
      scale_radii(p, edge);
    } catch (const ParameterError& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refusal(1e-3, 1e6, 8), "accepted");
  EXPECT_NE(refusal(1e-4, 8, 8).find("'r_min'"), std::string::npos);
  EXPECT_NE(refusal(1e-300, 8, 8).find("'r_min'"), std::string::npos);
  EXPECT_NE(refusal(1, 2e6, 8).find("'r_max'"), std::string::npos);
  EXPECT_NE(refusal(1e-4, 0, 8, RadiusChoice::fixed).find("'r_min'"), std::string::npos);
  EXPECT_NE(refusal(1, std::nextafter(1.0, 2.0), 2).find("thousandth"), std::string::npos);
  EXPECT_NE(refusal(1, 1.005, 8).find("reduce scales"), std::string::npos);
  EXPECT_EQ(refusal(1, 1.008, 8), "accepted");
}

TEST(Parameters, EveryRangeIsHeld)
{
  const auto rejected = [](const char* name, auto change) {
    Parameters p = published_method();
    change(p);
    try {
      validate(p);
      ADD_FAILURE() << name << " was accepted";
    } catch (const ParameterError& e) {
      EXPECT_NE(std::string(e.what()).find("'" + std::string(name) + "'"), std::string::npos) << e.what();
    }
  };
  const double nan = std::nan("");
  EXPECT_NO_THROW(validate({}));
  rejected("scales", [](Parameters& p) { p.scales = 0; });
  rejected("scales", [](Parameters& p) { p.scales = 33; });
  rejected("r_min", [](Parameters& p) { p.r_min = -1; });
  rejected("r_max", [&](Parameters& p) { p.r_max = nan; });
  rejected("radius", [](Parameters& p) { p.radius = HUGE_VAL; });
  rejected("alpha", [](Parameters& p) { p.alpha = 0; });
  rejected("step", [](Parameters& p) { p.step = 1.01; });
  rejected("max_iterations", [](Parameters& p) { p.max_iterations = -1; });
  rejected("tolerance", [](Parameters& p) { p.tolerance = 0; });
  rejected("smoothing_passes", [](Parameters& p) { p.smoothing_passes = 1001; });
  rejected("fft_cells_per_radius", [](Parameters& p) { p.fft_cells_per_radius = 0.5; });
  rejected("threads", [](Parameters& p) { p.threads = -1; });
  rejected("radius_choice", [](Parameters& p) { p.radius_choice = RadiusChoice(7); });
  rejected("engine", [](Parameters& p) { p.engine = EngineKind(-1); });
  rejected("scale_spacing", [](Parameters& p) { p.spacing = ScaleSpacing(2); });
  rejected("start_radius", [](Parameters& p) { p.start_radius = StartRadius(2); });
  rejected("exactness", [](Parameters& p) { p.exactness = Exactness(3); });
}
