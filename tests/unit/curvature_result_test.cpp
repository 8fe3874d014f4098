// SPDX-License-Identifier: GPL-3.0-or-later
#include "curvature_result.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace integral_invariant::filter {
namespace {

Result two_vertices()
{
  Result result;
  result.kappa_max = {2, 4};
  result.kappa_min = {0, -4};
  result.radius = {0.5, 1.5};
  result.confidence = {1, 0.25F};
  result.surface.vertices = 2;
  result.surface.boundary_edges = 3;
  result.surface.joined_vertices = 1;
  result.scales = {0.5, 1.5};
  result.average_edge = 0.5;
  result.diagonal = 10;
  result.converged = 2;
  result.engine = "test";
  result.stages = {{"first", 1.5}, {"second", 0.5}};
  return result;
}

std::string joined(const std::vector<std::string>& lines)
{
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

TEST(CurvatureResult, HoldsTheChosenQuantity)
{
  OutputOptions options;
  options.quality = Quantity::maximal;
  const FilterResult result = curvature_result(two_vertices(), options);
  EXPECT_EQ(result.quality, (std::vector<double>{2, 4}));
  EXPECT_EQ(result.colors.size(), 2u);
  ASSERT_TRUE(result.curvature.has_value());
  EXPECT_EQ(result.curvature->kappa_min, (std::vector<double>{0, -4}));
}

TEST(CurvatureResult, LinesTellScalesInAllUnitsAndDefects)
{
  const std::string text = joined(curvature_result(two_vertices(), {}).log);
  for (const char* part :
       {"2 vertices", "radii 0.5 1.5", "edge lengths: 1 3", "% of the diagonal: 5 15", "3 boundary edges",
        "1 vertices joined", "1 vertices with little", "Time: 2.00 s", "mean curvature in 1/L"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
}

TEST(CurvatureResult, ASoundMeshHasNoNote)
{
  Result result = two_vertices();
  result.surface.boundary_edges = result.surface.joined_vertices = 0;
  result.confidence = {1, 1};
  EXPECT_EQ(joined(curvature_result(result, {}).log).find("Note:"), std::string::npos);
}

TEST(CurvatureResult, ValuesHaveStatisticsOfEveryQuantity)
{
  const auto list = curvature_result(two_vertices(), {}).values;
  const std::map<std::string, SummaryValue> values(list.begin(), list.end());
  EXPECT_EQ(values.size(), list.size()) << "a name is there twice";
  EXPECT_EQ(std::get<int>(values.at("vertices")), 2);
  EXPECT_EQ(std::get<int>(values.at("low_confidence")), 1);
  EXPECT_DOUBLE_EQ(std::get<double>(values.at("median_radius")), 1);
  EXPECT_DOUBLE_EQ(std::get<double>(values.at("seconds")), 2);
  EXPECT_DOUBLE_EQ(std::get<double>(values.at("gaussian_min")), -16);
  EXPECT_DOUBLE_EQ(std::get<double>(values.at("largest_absolute_max")), 4);
}

}  // namespace
}  // namespace integral_invariant::filter
