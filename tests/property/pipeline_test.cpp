// SPDX-License-Identifier: GPL-3.0-or-later
// The whole pipeline: truth on a sphere, invariance, determinism, and what it refuses.
#include "integral_invariant/curvature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

TriangleMesh sample() { return with_normal_noise(torus(2, 0.6, 120, 36), 0.005); }

Parameters fixed_radius(double radius)
{
  Parameters p = published_method();
  p.radius_choice = RadiusChoice::fixed;
  p.radius = radius;
  return p;
}

/// Largest difference of two curvature fields, relative to the largest absolute value of the first.
double largest_difference(const std::vector<double>& a, const std::vector<double>& b, double factor = 1)
{
  double difference = 0, largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    difference = std::max(difference, std::abs(a[v] - factor * b[v]));
    largest = std::max(largest, std::abs(a[v]));
  }
  return difference / largest;
}

std::string refusal(const TriangleMesh& mesh, const Parameters& parameters)
{
  try {
    compute_curvature(mesh, parameters);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

bool mentions(const std::string& text, const std::string& word) { return text.find(word) != std::string::npos; }

const EngineKind engines[] = {EngineKind::volume_fft, EngineKind::surface_integral};

class Pipeline : public testing::TestWithParam<EngineKind> {
 protected:
  Parameters parameters() const
  {
    Parameters p = published_method();
    p.engine = GetParam();
    return p;
  }
};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Engines, Pipeline, testing::ValuesIn(engines), [](const auto& i) {
  return i.param == EngineKind::volume_fft ? "VolumeFft" : "SurfaceIntegral";
});

TEST_P(Pipeline, SphereIsWithinThreePercentAtEightEdges)
{
  const double sphere_radius = 3;
  const TriangleMesh mesh = icosphere(6, sphere_radius);
  ASSERT_EQ(mesh.positions.size(), 40962u);
  Parameters p = fixed_radius(8 * average_edge_length(mesh));
  p.engine = GetParam();
  const Result result = compute_curvature(mesh, p);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_LT(std::abs(result.kappa_max[v] * sphere_radius - 1), 0.03);
    EXPECT_LT(std::abs(result.kappa_min[v] * sphere_radius - 1), 0.03);
    EXPECT_GE(result.kappa_max[v], result.kappa_min[v]);
  }
}

TEST_P(Pipeline, TorusHasItsTwoCurvaturesAndDirections)
{
  const double major = 2, tube = 0.6;
  const int nv = 72;
  const TriangleMesh mesh = torus(major, tube, 240, nv);
  Parameters p = parameters();
  p.alpha = 0.5;  // small balls: the bias of [Yang06] falls with the square of the radius
  const Result result = compute_curvature(mesh, p);
  double error = 0, alignment = 1;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3& q = mesh.positions[i];
    const Vec3 axis_tangent = normalized({-q.y, q.x, 0});
    const double v = std::atan2(q.z, std::hypot(q.x, q.y) - major);
    error = std::max({error, std::abs(result.kappa_max[i] * tube - 1),
                      std::abs(result.kappa_min[i] - torus_curvature_around_axis(major, tube, v)) * tube});
    alignment = std::min(alignment, std::abs(dot(result.dir_min[i], axis_tangent)));
  }
  EXPECT_LT(error, 0.04);
  EXPECT_GT(alignment, std::cos(2 * 3.14159265 / 180));
}

TEST_P(Pipeline, ScaleDoesNotMatter)
{
  const TriangleMesh mesh = sample();
  const Result reference = compute_curvature(mesh, parameters());
  for (const double scale : {1e-6, 1e-3, 1e3, 1e6}) {
    const Result result = compute_curvature(scaled(mesh, scale), parameters());
    EXPECT_LT(largest_difference(reference.kappa_max, result.kappa_max, scale), 2e-5) << scale;
    EXPECT_LT(largest_difference(reference.kappa_min, result.kappa_min, scale), 2e-5) << scale;
    EXPECT_LT(largest_difference(reference.radius, result.radius, 1 / scale), 1e-3) << scale;
  }
}

TEST_P(Pipeline, ThreadsDoNotChangeABit)
{
  const TriangleMesh mesh = sample();
  Parameters one = parameters(), two = parameters(), five = parameters();
  one.threads = 1;
  two.threads = 2;
  five.threads = 5;
  const Result a = compute_curvature(mesh, one);
  for (const Parameters& p : {two, five}) {
    const Result b = compute_curvature(mesh, p);
    EXPECT_EQ(a.kappa_max, b.kappa_max);
    EXPECT_EQ(a.kappa_min, b.kappa_min);
    EXPECT_EQ(a.radius, b.radius);
    EXPECT_EQ(a.dir_max, b.dir_max);
    EXPECT_EQ(a.dir_min, b.dir_min);
  }
}

TEST_P(Pipeline, StrayVerticesAndBadTrianglesAreTolerated)
{
  TriangleMesh mesh = icosphere(4);
  const Result reference = compute_curvature(mesh, parameters());
  const std::size_t n = mesh.positions.size();
  mesh.positions.push_back({0.3, 0.2, 0.1});
  mesh.positions.push_back({std::nan(""), 0, 0});
  mesh.triangles.push_back(mesh.triangles[5]);
  mesh.triangles.push_back({3, 3, 4});
  mesh.triangles.push_back({0, 1, int(n) + 1});
  const Result result = compute_curvature(mesh, parameters());
  ASSERT_EQ(result.kappa_max.size(), n + 2);
  for (std::size_t v = 0; v < n; ++v) EXPECT_EQ(result.kappa_max[v], reference.kappa_max[v]);
  for (const std::size_t v : {n, n + 1}) {
    EXPECT_EQ(result.kappa_max[v], 0);
    EXPECT_EQ(result.confidence[v], 0);
    EXPECT_NEAR(norm(result.dir_max[v]), 1, 1e-12);
    EXPECT_NEAR(dot(result.dir_max[v], result.dir_min[v]), 0, 1e-12);
  }
}

TEST_P(Pipeline, InsideOutIsTurnedAroundAndSaidSo)
{
  const TriangleMesh mesh = icosphere(4);
  const Result straight = compute_curvature(mesh, parameters());
  const Result turned = compute_curvature(flipped(mesh), parameters());
  EXPECT_TRUE(turned.surface.inside_out);
  EXPECT_EQ(straight.kappa_max, turned.kappa_max);
}

TEST_P(Pipeline, CancelsWhenTheCallbackSaysSo)
{
  EXPECT_THROW(compute_curvature(icosphere(5), parameters(), [](int, const char*) { return false; }), Cancelled);
}

TEST_P(Pipeline, ReportsHowItCameAbout)
{
  const TriangleMesh mesh = sample();
  int last = -1;
  const Result result = compute_curvature(mesh, parameters(), [&](int percent, const char* stage) {
    EXPECT_GE(percent, last);
    EXPECT_LE(percent, 100);
    EXPECT_NE(std::string(stage), "");
    last = percent;
    return true;
  });
  EXPECT_GE(last, 0);
  EXPECT_EQ(result.scales.size(), 8u);
  EXPECT_NEAR(result.scales[2], 3 * average_edge_length(mesh), 1e-12);
  EXPECT_GT(result.converged, mesh.positions.size() * 9 / 10);
  EXPECT_FALSE(result.engine.empty());
  EXPECT_EQ(result.stages.size(), 6u);
}

TEST(PipelineRefuses, OpenSurfaceWithTheVolumeEngine)
{
  TriangleMesh open = icosphere(3);
  open.triangles.pop_back();
  Parameters p = published_method();
  p.engine = EngineKind::volume_fft;
  const std::string text = refusal(open, p);
  EXPECT_TRUE(mentions(text, "3 ")) << text;
  EXPECT_TRUE(mentions(text, "boundary edges")) << text;
  EXPECT_TRUE(mentions(text, "Close Holes")) << text;
}

TEST(PipelineRefuses, InconsistentOrientationWithTheVolumeEngine)
{
  TriangleMesh twisted = icosphere(3);
  std::swap(twisted.triangles[0][1], twisted.triangles[0][2]);
  Parameters p = published_method();
  p.engine = EngineKind::volume_fft;
  const std::string text = refusal(twisted, p);
  EXPECT_TRUE(mentions(text, "orient")) << text;
}

TEST(PipelineRefuses, MoreMemoryThanTheLimit)
{
  Parameters p = published_method();
  p.memory_limit_mb = 1;
  const std::string text = refusal(icosphere(6), p);
  EXPECT_TRUE(mentions(text, "memory_limit_mb")) << text;
}

TEST(PipelineRefuses, RadiiUnderATenthOfAnEdgeWithTheVolumeEngine)
{
  const TriangleMesh mesh = icosphere(2);
  Parameters p;
  p.r_min = 0.05 * average_edge_length(mesh);
  p.engine = EngineKind::surface_integral;
  EXPECT_EQ(refusal(mesh, p), "accepted");
  p.engine = EngineKind::volume_fft;
  EXPECT_TRUE(mentions(refusal(mesh, p), "r_min"));
}

TEST(PipelineRefuses, NoiseLargerThanTheMesh)
{
  Parameters p;
  p.noise = 1e200;
  EXPECT_TRUE(mentions(refusal(icosphere(2), p), "'noise'"));
}

TEST(PipelineRefuses, ParametersOutOfRange)
{
  Parameters p = published_method();
  p.scales = 99;
  EXPECT_TRUE(mentions(refusal(icosphere(2), p), "'scales'"));
}
