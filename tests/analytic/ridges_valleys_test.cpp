// SPDX-License-Identifier: GPL-3.0-or-later
// Ridge and valley regions: on a made-up field, and on a ridge of known place.
#include "integral_invariant/features/ridges_valleys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "integral_invariant/curvature.h"
#include "integral_invariant/error.h"
#include "support/feature_shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

/// A sphere on which κ_max is a given function of the place, and κ_min another.
template <class F, class G>
Result painted(const TriangleMesh& mesh, const F& kappa_max, const G& kappa_min)
{
  Result result;
  for (const Vec3& p : mesh.positions) {
    result.kappa_max.push_back(kappa_max(p));
    result.kappa_min.push_back(kappa_min(p));
  }
  result.average_edge = average_edge_length(mesh);
  return result;
}

RidgeValleyRegions regions_of(const Surface& surface, const Result& result, const RidgeValleyParameters& p)
{
  Execution execution;
  return find_ridges_and_valleys(surface, result, p, execution);
}

RidgeValleyParameters absolute(double high, double low)
{
  RidgeValleyParameters p;
  p.threshold = FeatureThreshold::curvature;
  p.high_curvature = high;
  p.low_curvature = low;
  return p;
}

std::size_t count(const RidgeValleyRegions& regions, FeatureKind kind)
{
  return std::size_t(std::count(regions.kind.begin(), regions.kind.end(), kind));
}

}  // namespace

TEST(RidgesAndValleys, HysteresisKeepsWeakVerticesOnlyNextToStrongOnes)
{
  const TriangleMesh mesh = icosphere(4);
  // Two caps above the low threshold; only the upper one has a top above the high one.
  const Result result = painted(
      mesh, [](const Vec3& p) { return p.z > 0.9             ? 10.0
                                       : std::abs(p.z) > 0.6 ? 5.0
                                                             : 1.0; },
      [](const Vec3&) { return 0.0; });
  const auto found = regions_of(Surface(mesh), result, absolute(8, 4));
  ASSERT_EQ(found.regions.size(), 1u);
  EXPECT_EQ(found.regions[0].kind, FeatureKind::ridge);
  EXPECT_NEAR(found.regions[0].area, 2 * 3.14159265 * (1 - 0.6), 0.2);
  EXPECT_DOUBLE_EQ(found.regions[0].peak, 10);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_EQ(found.kind[v] == FeatureKind::ridge, mesh.positions[v].z > 0.6) << mesh.positions[v].z;
}

TEST(RidgesAndValleys, SmallRegionsAreDroppedByVerticesAndByArea)
{
  const TriangleMesh mesh = icosphere(4);
  const Result result = painted(
      mesh, [](const Vec3& p) { return p.z > 0.8 || p.z < -0.95 ? 10.0 : 0.0; }, [](const Vec3&) { return 0.0; });
  RidgeValleyParameters p = absolute(8, 4);
  EXPECT_EQ(regions_of(Surface(mesh), result, p).regions.size(), 2u);
  p.minimum_vertices = 150;
  EXPECT_EQ(regions_of(Surface(mesh), result, p).regions.size(), 1u);
  p.minimum_vertices = 0;
  p.minimum_area = 0.6;
  const auto found = regions_of(Surface(mesh), result, p);
  ASSERT_EQ(found.regions.size(), 1u);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_EQ(found.region[v], mesh.positions[v].z > 0.8 ? 0 : -1);
}

TEST(RidgesAndValleys, PercentileMarksThatPartOfTheVertices)
{
  const TriangleMesh mesh = icosphere(5);
  const Result result = painted(
      mesh, [](const Vec3& p) { return p.z + 2; }, [](const Vec3& p) { return -(2 - p.z); });
  RidgeValleyParameters p;
  p.high_percentile = p.low_percentile = 90;
  const auto found = regions_of(Surface(mesh), result, p);
  const double part =
      double(count(found, FeatureKind::ridge) + count(found, FeatureKind::valley)) / double(mesh.positions.size());
  EXPECT_NEAR(part, 0.1, 0.01);
  EXPECT_EQ(found.regions.size(), 2u);  // |κ| is largest at both poles: a ridge at the upper, a valley at the lower one
  p.valleys = false;
  EXPECT_EQ(count(regions_of(Surface(mesh), result, p), FeatureKind::valley), 0u);
}

TEST(RidgesAndValleys, StandWhereTheyWereBuiltAlsoWithNoise)
{
  for (const double sigma : {0.0, 0.1})
    for (const double sign : {1.0, -1.0}) {
      const double step = 0.05, x0 = 1.237, width = 0.3;
      TriangleMesh mesh = box_with_ridge(2.5, 1, step, x0, 0.3 * sign, width);  // radius 0.3 at the crest
      const double edge = average_edge_length(mesh);
      mesh = with_normal_noise(mesh, sigma * edge);
      Parameters parameters;
      if (sigma > 0) parameters.r_min = 4 * edge;
      const auto found = regions_of(Surface(mesh), compute_curvature(mesh, parameters), absolute(1.8, 1.2));
      const FeatureKind kind = sign > 0 ? FeatureKind::ridge : FeatureKind::valley;
      double centre = 0, n = 0;
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Vec3& p = mesh.positions[v];
        const bool on_top = p.z > 0.7 && p.y > 0.5 && p.y < 2 && p.x > 0.5 && p.x < 2;
        if (!on_top) continue;
        if (std::abs(p.x - x0) < 0.03) { EXPECT_EQ(found.kind[v], kind); }
        if (found.kind[v] != kind) continue;
        EXPECT_LT(std::abs(p.x - x0), 0.3);
        centre += p.x;
        n += 1;
      }
      EXPECT_NEAR(centre / n, x0, edge);
    }
}

TEST(RidgesAndValleys, RefuseThresholdsThatContradict)
{
  const TriangleMesh mesh = icosphere(2);
  const Result result = ellipsoid_curvature(mesh, {1, 1, 1});
  const Surface surface(mesh);
  EXPECT_THROW(regions_of(surface, result, absolute(0, 0)), ParameterError);
  EXPECT_THROW(regions_of(surface, result, absolute(1, 2)), ParameterError);
  RidgeValleyParameters p;
  p.low_percentile = 99;
  EXPECT_THROW(regions_of(surface, result, p), ParameterError);
  p.high_percentile = 101;
  EXPECT_THROW(regions_of(surface, result, p), ParameterError);
}
