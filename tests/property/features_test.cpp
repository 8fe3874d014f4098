// SPDX-License-Identifier: GPL-3.0-or-later
// What must not change the features: the unit of the mesh, where it stands, the number of threads.
#include <gtest/gtest.h>

#include <cmath>

#include "integral_invariant/curvature.h"
#include "integral_invariant/features/crest_lines.h"
#include "integral_invariant/features/curvature_lines.h"
#include "support/feature_shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

struct Features {
  std::vector<CrestLine> crest;
  std::vector<CurvatureLine> lines;
  RidgeValleyRegions regions;
};

Features features(const TriangleMesh& mesh, int threads)
{
  Parameters parameters;
  parameters.threads = threads;
  const Result result = compute_curvature(mesh, parameters);
  const Surface surface(mesh);
  Execution execution(threads);
  DirectionParameters directions;
  directions.minimal = true;
  return {find_crest_lines(surface, curvature_field(result), {}, execution),
          trace_curvature_lines(surface, curvature_field(result), directions, execution),
          find_ridges_and_valleys(surface, result, {}, execution)};
}

TriangleMesh sample() { return with_tangential_jitter(with_normal_noise(ellipsoid(4, {2, 1.4, 0.8}), 0.002), 0.02); }

void expect_same_points(const std::vector<SurfacePoint>& a, const std::vector<SurfacePoint>& b, double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].vertices, b[i].vertices);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[i].weights[k], b[i].weights[k], tolerance);
  }
}

}  // namespace

TEST(Features, AreTheSameToTheBitWithAnyNumberOfThreads)
{
  const TriangleMesh mesh = sample();
  const Features one = features(mesh, 1), three = features(mesh, 3);
  ASSERT_EQ(one.crest.size(), three.crest.size());
  for (std::size_t i = 0; i < one.crest.size(); ++i) {
    expect_same_points(one.crest[i].points, three.crest[i].points, 0);
    EXPECT_EQ(one.crest[i].strength, three.crest[i].strength);
  }
  ASSERT_EQ(one.lines.size(), three.lines.size());
  for (std::size_t i = 0; i < one.lines.size(); ++i) expect_same_points(one.lines[i].points, three.lines[i].points, 0);
  EXPECT_EQ(one.regions.kind, three.regions.kind);
}

TEST(Features, DoNotDependOnTheUnitOfTheMesh)
{
  const TriangleMesh mesh = sample();
  const Features reference = features(mesh, 0);
  for (const double factor : {0x1p-20, 0x1p20}) {  // powers of two: the same mantissas
    const Features other = features(scaled(mesh, factor), 0);
    ASSERT_EQ(reference.crest.size(), other.crest.size());
    for (std::size_t i = 0; i < reference.crest.size(); ++i) {
      EXPECT_NEAR(reference.crest[i].strength, other.crest[i].strength, 1e-9);
      EXPECT_NEAR(reference.crest[i].sharpness, other.crest[i].sharpness, 1e-9);
      EXPECT_NEAR(reference.crest[i].length * factor, other.crest[i].length, 1e-9 * other.crest[i].length);
    }
    ASSERT_EQ(reference.lines.size(), other.lines.size());
    for (std::size_t i = 0; i < reference.lines.size(); ++i)
      expect_same_points(reference.lines[i].points, other.lines[i].points, 1e-6);
    EXPECT_EQ(reference.regions.kind, other.regions.kind);
    EXPECT_NEAR(reference.regions.high, other.regions.high * factor, 1e-9 * reference.regions.high);
  }
}

TEST(Features, OfBrokenMeshesAreFinite)
{
  TriangleMesh mesh = sample();
  mesh.triangles.resize(mesh.triangles.size() / 2);                           // open, with a ragged rim
  mesh.triangles.push_back(mesh.triangles[7]);                                // twice the same
  mesh.triangles.push_back({mesh.triangles[9][0], mesh.triangles[9][1], 5});  // three at an edge
  mesh.positions.push_back({std::nan(""), 0, 0});
  const Features found = features(mesh, 0);
  for (const CurvatureLine& line : found.lines)
    for (const SurfacePoint& p : line.points) ASSERT_TRUE(is_finite(interpolate(mesh.positions, p)));
  for (const CrestLine& line : found.crest) {
    EXPECT_TRUE(std::isfinite(line.strength) && std::isfinite(line.sharpness));
    for (const SurfacePoint& p : line.points) ASSERT_TRUE(is_finite(interpolate(mesh.positions, p)));
  }
}

TEST(Features, CanBeCancelled)
{
  const TriangleMesh mesh = sample();
  const Result result = ellipsoid_curvature(mesh, {2, 1.4, 0.8});
  Execution execution(2, [](int, const char*) { return false; });
  EXPECT_THROW(
      {
        execution.begin_stage("lines", 100);
        trace_curvature_lines(Surface(mesh), curvature_field(result), {}, execution);
      },
      Cancelled);
}
