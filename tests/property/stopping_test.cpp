// SPDX-License-Identifier: GPL-3.0-or-later
// How soon a run on a large mesh asks whether to go on: the longest processor time between two calls of the callback,
// in every stage, must leave the user waiting 0.2 s at most. And that the worst of meshes do not make it wait for ever.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <random>

#include "integral_invariant/curvature.h"
#include "integral_invariant/features/crest_lines.h"
#include "integral_invariant/features/curvature_lines.h"
#include "integral_invariant/features/signature.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

constexpr double longest_wait = 0.2;  // s
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double slowdown = 10;
#else
constexpr double slowdown = 1;
#endif

const TriangleMesh& large_mesh()
{
  static const TriangleMesh mesh = with_normal_noise(torus(2, 0.6, 780, 210), 0.001);
  return mesh;
}

/// Processor time of the calling thread, which the load of the machine does not change. With one thread all work is
/// its.
double processor_seconds()
{
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Holds every gap between two calls, and that to the end, under the limit.
class Watch {
 public:
  bool call(const char* stage)
  {
    tick();
    stage_ = stage;
    return true;
  }
  void tick()
  {
    const double now = processor_seconds();
    EXPECT_LT(now - last_, longest_wait * slowdown) << "after a call in the stage: " << stage_;
    last_ = processor_seconds();
  }
  ProgressCallback callback()
  {
    return [this](int, const char* stage) { return call(stage); };
  }

 private:
  double last_ = processor_seconds();
  std::string stage_ = "(none)";
};

Parameters on_one_thread(Parameters p)
{
  p.threads = 1;
  return p;
}

/// Two cones over a circle: every vertex of it is a neighbour of both tips.
TriangleMesh double_cone(int sides)
{
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0.3}, {0, 0, -0.3}};
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * 3.14159265358979 * i / sides;
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 0});
    const int a = 2 + i, b = 2 + (i + 1) % sides;
    mesh.triangles.push_back({0, a, b});
    mesh.triangles.push_back({1, b, a});
  }
  return mesh;
}

/// Triangles that share nothing, half as wide as the cube that they fill.
TriangleMesh random_soup(int triangles)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  const auto point = [&] { return Vec3{share(random), share(random), share(random)}; };
  TriangleMesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const Vec3 place = point();
    for (int corner = 0; corner < 3; ++corner) mesh.positions.push_back(place + point() * 0.5);
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// A prism whose sides are two triangles each, `length` times as long as its radius.
TriangleMesh prism(int sides, double length)
{
  TriangleMesh mesh;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * 3.14159265358979 * i / sides;
    for (const double z : {0.0, length}) mesh.positions.push_back({std::cos(angle), std::sin(angle), z});
    const int a = 2 * i, b = 2 * ((i + 1) % sides);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
  return mesh;
}

TriangleMesh randomly_oriented(TriangleMesh mesh)
{
  std::mt19937 random(5);
  for (Triangle& t : mesh.triangles)
    if (random() & 1) std::swap(t[1], t[2]);
  return mesh;
}

/// Of the default; with noise 0 it is estimated.
double seconds_of_default(const TriangleMesh& mesh, double noise)
{
  Parameters p = on_one_thread({});
  p.noise = noise;
  const double start = processor_seconds();
  compute_curvature(mesh, p);
  return processor_seconds() - start;
}

}  // namespace

TEST(Stopping, TimeDoesNotGrowWithTheSquareOfAHubsSpokes)
{
  constexpr int sides = 10000, times = 4;
  // Known: what a double cone shows of noise is chance, and chance decides how many discs there are.
  constexpr double noise = 1e-4;
  const TriangleMesh large = double_cone(times * sides);
  const double few = seconds_of_default(double_cone(sides), noise), many = seconds_of_default(large, noise);
  EXPECT_LT(many, 2 * times * few);
  EXPECT_LT(seconds_of_default(large, 0), 2 * many) << "with estimated noise";
}

TEST(Stopping, TimeDoesNotGrowWithTheSquareOfTrianglesThatAreNoSurface)
{
  constexpr int few = 4000, times = 4;
  EXPECT_LT(seconds_of_default(random_soup(times * few), 0), 2 * times * seconds_of_default(random_soup(few), 0));
  EXPECT_LT(seconds_of_default(prism(times * few, 50), 0), 2 * times * seconds_of_default(prism(few, 50), 0));
}

TEST(Stopping, RandomOrientationCostsAFewTimesASurface)
{
  const TriangleMesh mesh = with_normal_noise(torus(2, 0.6, 300, 90), 0.002);
  EXPECT_LT(seconds_of_default(randomly_oriented(mesh), 0), 4 * seconds_of_default(mesh, 0));
}

TEST(Stopping, WhatIsNoSurfaceIsAskedForOftenEnough)
{
  for (const TriangleMesh& mesh : {random_soup(4000), prism(8000, 50), randomly_oriented(torus(2, 0.6, 300, 90))}) {
    Watch watch;
    compute_curvature(mesh, on_one_thread({}), watch.callback());
    watch.tick();
  }
}

TEST(Stopping, StatisticalRadiusAsksOftenEnough)
{
  ASSERT_GT(large_mesh().positions.size(), 150000u);
  Watch watch;
  compute_curvature(large_mesh(), on_one_thread({}), watch.callback());
  watch.tick();
}

TEST(Stopping, AMillionVerticesAreAskedForOftenEnough)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "Takes too long under a sanitizer.";
#endif
  const TriangleMesh mesh = with_normal_noise(torus(2, 0.6, 1800, 560), 0.0005);
  ASSERT_GT(mesh.positions.size(), 1000000u);
  Watch watch;
  compute_curvature(mesh, on_one_thread({}), watch.callback());
  watch.tick();
}

TEST(Stopping, AdaptedRadiusAsksOftenEnough)
{
  Parameters p = on_one_thread(published_method());
  p.estimator = Estimator::bias_free;
  Watch watch;
  compute_curvature(large_mesh(), p, watch.callback());
  watch.tick();
}

TEST(Stopping, VolumeEngineAsksOftenEnough)
{
  Parameters p = on_one_thread({});
  p.engine = EngineKind::volume_fft;
  p.scales = 3;
  p.r_min = 4 * average_edge_length(large_mesh());
  Watch watch;
  compute_curvature(large_mesh(), p, watch.callback());
  watch.tick();
}

TEST(Stopping, FeaturesAskOftenEnough)
{
  const Result result = compute_curvature(large_mesh(), on_one_thread({}), {});
  const Surface surface(large_mesh());
  const CurvatureField field = curvature_field(result);
  Watch watch;
  Execution execution(1, watch.callback());
  execution.begin_stage("crest lines", 50);
  CrestLineParameters crest;
  crest.minimum_sharpness = 0;
  find_crest_lines(surface, field, crest, execution);
  execution.begin_stage("directions", 100);
  trace_curvature_lines(surface, field, {}, execution);
  execution.finish();
  watch.tick();
}
