// SPDX-License-Identifier: GPL-3.0-or-later
// Crest lines where they are known: the long rim of an ellipsoid, a ridge and a valley on a box; with noise.
#include "integral_invariant/features/crest_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "integral_invariant/curvature.h"
#include "support/feature_shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

const Vec3 axes{2, 1.4, 0.8};

std::vector<CrestLine> crest_lines(const TriangleMesh& mesh, const Result& result, const CrestLineParameters& p = {})
{
  Execution execution;
  return find_crest_lines(Surface(mesh), curvature_field(result), p, execution);
}

double rim_length()
{
  double length = 0;
  for (int i = 0; i < 3600; ++i) {
    const double u = 2 * 3.14159265358979 * i / 3600;
    length += std::hypot(axes.x * std::sin(u), axes.y * std::cos(u)) * 2 * 3.14159265358979 / 3600;
  }
  return length;
}

template <class Distance>
double largest_distance(const TriangleMesh& mesh, const CrestLine& line, const Distance& distance)
{
  double largest = 0;
  for (const SurfacePoint& p : line.points) largest = std::max(largest, distance(interpolate(mesh.positions, p)));
  return largest;
}

}  // namespace

TEST(CrestLines, OfAnExactEllipsoidAreItsLongRimOnce)
{
  const TriangleMesh mesh = rotated(ellipsoid(5, axes), {0, 0, 1}, 0);
  const auto lines = crest_lines(mesh, ellipsoid_curvature(mesh, axes));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].closed);
  EXPECT_EQ(lines[0].kind, FeatureKind::ridge);
  EXPECT_NEAR(lines[0].length, rim_length(), 0.02 * rim_length());
  EXPECT_LT(largest_distance(mesh, lines[0], [](const Vec3& p) { return std::abs(p.z); }),
            0.2 * average_edge_length(mesh));
}

TEST(CrestLines, StrengthAndSharpnessHaveTheirClosedForms)
{
  const TriangleMesh mesh = ellipsoid(6, {1, 1, 0.5});
  const Result result = ellipsoid_curvature(mesh, {1, 1, 0.5});
  CrestLineParameters p;
  p.smoothing_passes = 0;
  const auto lines = crest_lines(mesh, result, p);
  ASSERT_EQ(lines.size(), 1u);
  // Oblate spheroid: κ_max = a/c² = 4 on the equator of length 2π; sharpness of the ellipse's end 3 (1 − c²/a²).
  EXPECT_NEAR(lines[0].strength, 4 * 2 * 3.14159265, 0.5);
  EXPECT_NEAR(lines[0].sharpness, 3 * (1 - 0.25),
              0.6);  // a difference over half a radius sees less than the derivative
}

TEST(CrestLines, OfASphereAndATorusAreNone)
{
  const TriangleMesh sphere = icosphere(5, 1);
  EXPECT_TRUE(crest_lines(sphere, compute_curvature(sphere, {})).empty());
  const TriangleMesh ring = torus(2, 0.6, 120, 36);
  EXPECT_TRUE(crest_lines(ring, torus_curvature(ring, 2, 0.6)).empty());
}

TEST(CrestLines, OfANoisyEllipsoidAreItsRim)
{
  const TriangleMesh clean = ellipsoid(5, axes);
  const double edge = average_edge_length(clean);
  const TriangleMesh mesh = with_normal_noise(clean, 0.1 * edge);
  Parameters parameters;
  parameters.r_min = 4 * edge;
  const auto lines = crest_lines(mesh, compute_curvature(mesh, parameters));
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].closed);
  EXPECT_LT(largest_distance(mesh, lines[0], [](const Vec3& p) { return std::abs(p.z); }), edge);
}

TEST(CrestLines, FindARidgeAndAValleyOfKnownRadiusWithinAnEdge)
{
  for (const double sigma : {0.0, 0.1})
    for (const double sign : {1.0, -1.0}) {
      const double step = 0.05, x0 = 1.237, width = 0.3, ridge_height = 0.3 * sign;
      TriangleMesh mesh = box_with_ridge(2.5, 1, step, x0, ridge_height, width);
      const double edge = average_edge_length(mesh);
      mesh = with_normal_noise(mesh, sigma * edge);
      Parameters parameters;
      if (sigma > 0)
        parameters.r_min = 4 * edge;
      else
        parameters.alpha = 0.5;  // small balls: little bias
      const Result result = compute_curvature(mesh, parameters);
      const auto lines = crest_lines(mesh, result);
      double found = 0, curvature = 0, off = 0;
      for (const CrestLine& line : lines) {
        if (line.kind != (sign > 0 ? FeatureKind::ridge : FeatureKind::valley)) continue;
        for (const SurfacePoint& p : line.points) {
          const Vec3 q = interpolate(mesh.positions, p);
          if (q.z < 0.6 || q.y < 0.4 || q.y > 2.1 || std::abs(q.x - x0) > 0.5) continue;
          off = std::max(off, std::abs(q.x - x0));
          found += 1;
          curvature += sign > 0 ? interpolate(result.kappa_max, p) : -interpolate(result.kappa_min, p);
        }
      }
      EXPECT_GT(found, 1.7 / step);
      EXPECT_LT(off, edge);
      EXPECT_NEAR(curvature / found * width * width / std::abs(ridge_height), sigma > 0 ? 0.7 : 0.9, 0.15);
    }
}
