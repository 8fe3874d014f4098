// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/moments/fft/fft_engine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "integral_invariant/ball_curvature/curvature_tensor.h"
#include "integral_invariant/error.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

constexpr double pi = 3.14159265358979323846;

std::vector<BallMoments> moments_of(const Surface& surface, double radius, double cells, int threads = 2,
                                    std::size_t memory_mb = 0)
{
  Parameters parameters;
  parameters.fft_cells_per_radius = cells;
  parameters.memory_limit_mb = memory_mb;
  Execution execution(threads);
  std::vector<BallMoments> result(surface.vertex_count());
  make_fft_engine(surface, parameters)
      ->evaluate(
          {radius}, [&](std::size_t v, int, const BallMoments& m) { result[v] = m; }, execution);
  return result;
}

std::vector<double> curvatures(const std::vector<BallMoments>& moments, double radius)
{
  std::vector<double> values;
  for (const BallMoments& m : moments) {
    const PrincipalCurvatures k = principal_curvatures(curvature_tensor(m, radius));
    values.push_back(k.kappa_max * radius);
    values.push_back(k.kappa_min * radius);
  }
  return values;
}

double rms_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / double(a.size()));
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Vertices inside the side z = height of box(), farther than `margin` from its rim, before any rotation.
std::vector<std::size_t> inner_vertices(const TriangleMesh& mesh, double height, double a, double b, double margin)
{
  std::vector<std::size_t> inner;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    if (std::abs(p.z - height) < 1e-9 && std::min(p.x, p.y) > margin && p.x < a - margin && p.y < b - margin)
      inner.push_back(v);
  }
  return inner;
}

TEST(FftEngine, HalfSpaceHasItsClosedForm)
{
  const TriangleMesh mesh = box(1, 1, 1, 0.05);
  const Surface surface(rotated(mesh, normalized({1, 2, 3}), 0.7));
  const Vec3 outward = rotated(Vec3{0, 0, 1}, normalized({1, 2, 3}), 0.7);
  const double r = 5;
  const auto moments = moments_of(surface, r, 8);
  for (const std::size_t v : inner_vertices(mesh, 1, 1, 1, 1.25 * r * surface.unit())) {
    EXPECT_NEAR(moments[v].volume, 2 * pi / 3 * r * r * r, 1e-3 * r * r * r);
    EXPECT_LT(norm(moments[v].first + outward * (pi / 4 * std::pow(r, 4))), 1e-3 * std::pow(r, 4));
    const Symmetric3 error = moments[v].second - Symmetric3::identity(2 * pi / 15 * std::pow(r, 5));
    for (const double e : {error.xx, error.xy, error.xz, error.yy, error.yz, error.zz})
      EXPECT_LT(std::abs(e), 1e-3 * std::pow(r, 5));
  }
}

TEST(FftEngine, SlabThinnerThanTheBallHasItsClosedForm)
{
  const TriangleMesh mesh = box(1, 1, 0.1, 0.05);
  const Surface surface(rotated(mesh, normalized({2, -1, 1}), 0.5));
  const double r = 3.5, t = 0.1 / surface.unit();
  const auto moments = moments_of(surface, r, 8);
  const double volume = pi * (r * r * t - t * t * t / 3);
  const double first = pi * (r * r * t * t / 2 - std::pow(t, 4) / 4);
  for (const std::size_t v : inner_vertices(mesh, 0.1, 1, 1, r * surface.unit() + 1e-6)) {
    EXPECT_NEAR(moments[v].volume, volume, 2e-3 * r * r * r);
    EXPECT_NEAR(norm(moments[v].first), first, 2e-3 * std::pow(r, 4));
    EXPECT_NEAR(moments[v].second.trace(), pi / 2 * (std::pow(r, 4) * t - std::pow(t, 5) / 5), 2e-3 * std::pow(r, 5));
  }
}

TEST(FftEngine, SphereHasTheVolumeOfTheLens)
{
  const Surface surface(icosphere(5));
  const double radius_of_sphere = 1 / surface.unit(), r = 8;
  const double lens = 2 * pi / 3 * r * r * r - pi / 4 * std::pow(r, 4) / radius_of_sphere;
  for (const BallMoments& m : moments_of(surface, r, 8)) EXPECT_NEAR(m.volume, lens, 4e-3 * r * r * r);
}

TEST(FftEngine, EveryVertexOfAnIcosphereIsWithinThreePercent)
{
  const Surface surface(icosphere(6));
  ASSERT_EQ(surface.vertex_count(), 40962u);
  const double r = 8;
  for (const double kappa_r : curvatures(moments_of(surface, r, 6), r))
    EXPECT_NEAR(kappa_r / r / surface.unit(), 1, 0.03);
}

TEST(FftEngine, ErrorFallsWithAtLeastTheSecondOrderOfTheGridStep)
{
  for (const TriangleMesh& mesh : {icosphere(4), torus(1, 0.4, 80, 32), box(1, 1, 1, 0.05)}) {
    const Surface surface(rotated(mesh, normalized({1, 2, 3}), 0.7));
    const double r = 5;
    const auto reference = curvatures(moments_of(surface, r, 20), r);
    const double coarse = rms_difference(curvatures(moments_of(surface, r, 4), r), reference);
    const double fine = rms_difference(curvatures(moments_of(surface, r, 8), r), reference);
    EXPECT_GT(std::log2(coarse / fine), 2.0);
    EXPECT_LT(fine, 2e-3);
  }
}

TEST(FftEngine, ThreadsDoNotChangeABit)
{
  const Surface surface(rotated(torus(1, 0.4, 120, 48), normalized({1, 2, 3}), 0.7));
  for (const double r : {1.0, 6.0})
    for (const int threads : {2, 3}) {
      const auto one = moments_of(surface, r, 4, 1), more = moments_of(surface, r, 4, threads);
      for (std::size_t v = 0; v < one.size(); ++v) {
        ASSERT_EQ(one[v].volume, more[v].volume);
        ASSERT_EQ(one[v].first, more[v].first);
        ASSERT_EQ(one[v].second.xy, more[v].second.xy);
        ASSERT_EQ(one[v].second.zz, more[v].second.zz);
      }
    }
}

/// Kernels of a finite band ring beyond the ball, and tiles cut that off: they differ by less than the grid's own
/// error.
TEST(FftEngine, TilesAgreeWithTheWholeGrid)
{
  const Surface surface(rotated(torus(1, 0.4, 160, 64), normalized({1, 2, 3}), 0.7));
  Parameters parameters;
  parameters.fft_cells_per_radius = 5;
  parameters.memory_limit_mb = 1;
  Execution execution;
  const std::string cut_up = make_fft_engine(surface, parameters)->description({5}, execution);
  EXPECT_EQ(cut_up.find(" 1 x 11 of"), std::string::npos) << cut_up;
  const auto tiled = curvatures(moments_of(surface, 5, 5, 2, 1), 5), whole = curvatures(moments_of(surface, 5, 5), 5);
  const auto reference = curvatures(moments_of(surface, 5, 16), 5);
  EXPECT_LT(rms_difference(tiled, whole), rms_difference(whole, reference));
  EXPECT_LT(largest_difference(tiled, whole), 4e-3);
}

TEST(FftEngine, RigidMotionsAndUnitsKeepTheCurvature)
{
  const TriangleMesh mesh = torus(1, 0.4, 120, 48);
  const Surface still(mesh);
  const Surface moved(scaled(translated(rotated(mesh, normalized({3, 1, -2}), 1.3), {100, -50, 7}), 1e-4));
  const double r = 5;
  const auto a = curvatures(moments_of(still, r, 8), r), b = curvatures(moments_of(moved, r, 8), r);
  EXPECT_LT(rms_difference(a, b), 1e-3);
  EXPECT_LT(largest_difference(a, b), 6e-3);
}

TEST(FftEngine, OpenSurfaceIsRefusedWithAdvice)
{
  TriangleMesh mesh = icosphere(2);
  mesh.triangles.pop_back();
  const Surface surface(mesh);
  try {
    make_fft_engine(surface, {});
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("3 boundary edges"), std::string::npos) << text;
    EXPECT_NE(text.find("Close Holes"), std::string::npos);
  }
}

TEST(FftEngine, TooLittleMemoryIsRefusedWithAdvice)
{
  const Surface surface(icosphere(3));
  try {
    moments_of(surface, 4, 60, 1, 1);
    FAIL();
  } catch (const MemoryError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("cells"), std::string::npos);
    EXPECT_NE(text.find("fft_cells_per_radius"), std::string::npos);
  }
}

TEST(FftEngine, StopsWhenAsked)
{
  const Surface surface(icosphere(5));
  Execution execution(2, [](int, const char*) { return false; });
  const auto sink = [](std::size_t, int, const BallMoments&) {};
  EXPECT_THROW(make_fft_engine(surface, {})->evaluate({1, 2, 3}, sink, execution), Cancelled);
}

}  // namespace
