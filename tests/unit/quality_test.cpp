// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality.h"

#include <gtest/gtest.h>

#include <cmath>

namespace integral_invariant::filter {
namespace {

Result one_vertex(double k_max, double k_min, double radius = 1)
{
  Result result;
  result.kappa_max = {k_max};
  result.kappa_min = {k_min};
  result.radius = {radius};
  return result;
}

double value(Quantity quantity, double k_max, double k_min, double radius = 1)
{
  return quantity_values(one_vertex(k_max, k_min, radius), quantity).at(0);
}

TEST(Quality, Formulas)
{
  EXPECT_DOUBLE_EQ(value(Quantity::mean, 3, -1), 1);
  EXPECT_DOUBLE_EQ(value(Quantity::gaussian, 3, -1), -3);
  EXPECT_DOUBLE_EQ(value(Quantity::maximal, 3, -1), 3);
  EXPECT_DOUBLE_EQ(value(Quantity::minimal, 3, -1), -1);
  EXPECT_DOUBLE_EQ(value(Quantity::curvedness, 3, -1), std::sqrt(5));
  EXPECT_DOUBLE_EQ(value(Quantity::radius, 3, -1, 0.25), 0.25);
  EXPECT_DOUBLE_EQ(value(Quantity::largest_absolute, 1, -3), 3);
  EXPECT_DOUBLE_EQ(value(Quantity::largest_absolute, 3, -1), 3);
}

TEST(Quality, ShapeIndexOfTheClassicShapes)
{
  EXPECT_DOUBLE_EQ(value(Quantity::shape_index, 2, 2), 1);      // cap
  EXPECT_DOUBLE_EQ(value(Quantity::shape_index, 2, 0), 0.5);    // ridge
  EXPECT_DOUBLE_EQ(value(Quantity::shape_index, 2, -2), 0);     // saddle
  EXPECT_DOUBLE_EQ(value(Quantity::shape_index, 0, -2), -0.5);  // rut
  EXPECT_DOUBLE_EQ(value(Quantity::shape_index, -2, -2), -1);   // cup
  EXPECT_DOUBLE_EQ(value(Quantity::shape_index, 0, 0), 0);      // flat
}

TEST(Quality, HugeCurvaturesDoNotOverflowCurvedness)
{
  EXPECT_TRUE(std::isfinite(value(Quantity::curvedness, 1e200, 1e200)));
}

TEST(Percentile, InterpolatesBetweenNeighbours)
{
  EXPECT_DOUBLE_EQ(percentile({4, 1, 3, 2}, 0), 1);
  EXPECT_DOUBLE_EQ(percentile({4, 1, 3, 2}, 50), 2.5);
  EXPECT_DOUBLE_EQ(percentile({4, 1, 3, 2}, 100), 4);
  EXPECT_DOUBLE_EQ(percentile({7}, 95), 7);
  EXPECT_DOUBLE_EQ(percentile({}, 95), 0);
}

TEST(Percentile, StatisticsAreInOrder)
{
  std::vector<double> values;
  for (int i = 100; i >= 0; --i) values.push_back(i);
  const Statistics s = statistics(values);
  EXPECT_DOUBLE_EQ(s.minimum, 0);
  EXPECT_DOUBLE_EQ(s.p5, 5);
  EXPECT_DOUBLE_EQ(s.median, 50);
  EXPECT_DOUBLE_EQ(s.p95, 95);
  EXPECT_DOUBLE_EQ(s.maximum, 100);
}

TEST(ColorRange, IsSymmetricForSignedQuantities)
{
  const ColorRange range = color_range({-10, 1, 2, 3}, Quantity::mean, 100);
  EXPECT_DOUBLE_EQ(range.low, -10);
  EXPECT_DOUBLE_EQ(range.high, 10);
}

TEST(ColorRange, LeavesOutAsMuchBelowAsAboveForTheOthers)
{
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back(i);
  const ColorRange range = color_range(values, Quantity::radius, 90);
  EXPECT_NEAR(range.low, 5, 1e-12);
  EXPECT_NEAR(range.high, 95, 1e-12);
}

TEST(ColorRange, ShapeIndexHasItsOwn)
{
  const ColorRange range = color_range({0.1, 0.2}, Quantity::shape_index, 95);
  EXPECT_DOUBLE_EQ(range.low, -1);
  EXPECT_DOUBLE_EQ(range.high, 1);
}

TEST(ColorMap, ShowsTheSign)
{
  const ColorRange range{-1, 1};
  const Color negative = color_of(-1, range, Quantity::mean), zero = color_of(0, range, Quantity::mean),
              positive = color_of(1, range, Quantity::mean);
  EXPECT_GT(negative[2], negative[0]);
  EXPECT_GT(positive[0], positive[2]);
  EXPECT_EQ(zero[0], zero[2]);
}

TEST(ColorMap, EndsHoldOutsideTheRangeAndAnEmptyRangeHasOneColour)
{
  const ColorRange range{0, 2}, empty{3, 3};
  EXPECT_EQ(color_of(-5, range, Quantity::radius), color_of(0, range, Quantity::radius));
  EXPECT_EQ(color_of(50, range, Quantity::radius), color_of(2, range, Quantity::radius));
  EXPECT_EQ(color_of(2, empty, Quantity::radius), color_of(4, empty, Quantity::radius));
}

}  // namespace
}  // namespace integral_invariant::filter
