// SPDX-License-Identifier: GPL-3.0-or-later
// The statistical choice of the scales on meshes whose curvature is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "integral_invariant/curvature.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

Parameters statistical() { return {}; }

TriangleMesh noisy_sphere(double sigma, double radius = 1)
{
  TriangleMesh mesh = icosphere(4, radius);
  return with_normal_noise(mesh, sigma * average_edge_length(mesh));
}

double mean_error(const Result& r, double kappa)
{
  double sum = 0;
  for (std::size_t v = 0; v < r.kappa_max.size(); ++v)
    sum += std::abs(r.kappa_max[v] - kappa) + std::abs(r.kappa_min[v] - kappa);
  return sum / (2 * kappa * double(r.kappa_max.size()));
}

}  // namespace

TEST(Statistical, SphereWithoutNoise)
{
  for (const EngineKind engine : {EngineKind::surface_integral, EngineKind::volume_fft}) {
    Parameters p = statistical();
    p.engine = engine;
    EXPECT_LT(mean_error(compute_curvature(icosphere(4, 2), p), 0.5), 1e-4);
  }
}

TEST(Statistical, NoiseIsEstimatedWithinATenth)
{
  for (const double sigma : {0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) {
    const TriangleMesh clean = icosphere(4);
    const Result r = compute_curvature(noisy_sphere(sigma), statistical());
    EXPECT_NEAR(r.noise / average_edge_length(clean), sigma, 0.1 * sigma) << sigma;
  }
}

// Bumps of twenty edges: what polynomials leave over of them is no noise, and no reason to trust balls more.
TEST(Statistical, ShapeIsNotTakenForNoise)
{
  constexpr int side = 60;
  TriangleMesh mesh;
  for (int i = 0; i <= side; ++i)
    for (int j = 0; j <= side; ++j) mesh.positions.push_back({i - side / 2.0, j - side / 2.0, 0});
  for (int a = 0; a + side + 2 < int(mesh.positions.size()); ++a) {
    if (a % (side + 1) == side) continue;
    mesh.triangles.push_back({a, a + side + 1, a + side + 2});
    mesh.triangles.push_back({a, a + side + 2, a + 1});
  }
  const double edge = average_edge_length(mesh), q = 2 * 3.14159265358979 / (20 * edge), height = 0.3 * edge;
  mesh = with_tangential_jitter(mesh, 0.2 * edge);
  for (Vec3& p : mesh.positions) p.z = height * std::sin(q * p.x) * std::sin(q * p.y);
  const Result estimated = compute_curvature(mesh, statistical());
  Parameters p = statistical();
  p.noise = estimated.noise;  // and it is noise
  const Result told = compute_curvature(mesh, p);

  double error = 0, error_if_noise = 0, size = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& at = mesh.positions[v];
    if (std::max(std::abs(at.x), std::abs(at.y)) > 20 * edge) continue;
    const double sx = std::sin(q * at.x), cx = std::cos(q * at.x), sy = std::sin(q * at.y), cy = std::cos(q * at.y);
    const double zx = height * q * cx * sy, zy = height * q * sx * cy, zxy = height * q * q * cx * cy,
                 zxx = -height * q * q * sx * sy, zyy = zxx;
    const double h =
        -((1 + zy * zy) * zxx - 2 * zx * zy * zxy + (1 + zx * zx) * zyy) / (2 * std::pow(1 + zx * zx + zy * zy, 1.5));
    error += std::abs((estimated.kappa_max[v] + estimated.kappa_min[v]) / 2 - h);
    error_if_noise += std::abs((told.kappa_max[v] + told.kappa_min[v]) / 2 - h);
    size += std::abs(h);
  }
  EXPECT_LT(error, 0.003 * size);
  EXPECT_LT(error, 0.5 * error_if_noise);
}

TEST(Statistical, NoisySphere)
{
  EXPECT_LT(mean_error(compute_curvature(noisy_sphere(0.1), statistical()), 1), 0.04);
  EXPECT_LT(mean_error(compute_curvature(noisy_sphere(0.5), statistical()), 1), 0.12);
}

// A torus's curvatures change from scale to scale, its directions do not: they are those of balls that average the
// noise.
TEST(Statistical, DirectionsStayWhereOnlyCurvaturesChangeWithTheScale)
{
  const TriangleMesh clean = torus(1, 0.4, 128, 80);
  const Result r = compute_curvature(with_normal_noise(clean, 0.1 * average_edge_length(clean)), statistical());
  double angles = 0;
  for (std::size_t v = 0; v < clean.positions.size(); ++v) {
    const Vec3& p = clean.positions[v];
    const Vec3 along = normalized({-p.y, p.x, 0});  // around the axis
    angles += std::asin(std::min(1.0, norm(cross(r.dir_min[v], along))));
  }
  EXPECT_LT(angles / double(clean.positions.size()) * 180 / 3.14159265358979, 0.15);
}

TEST(Statistical, GivenNoiseIsTaken)
{
  Parameters p = statistical();
  p.noise = 0.25;
  EXPECT_EQ(compute_curvature(icosphere(3), p).noise, 0.25);
}

TEST(Statistical, StandardErrorCoversAboutTwoThirds)
{
  const TriangleMesh clean = torus(1, 0.4, 120, 48);
  const Result r = compute_curvature(with_normal_noise(clean, 0.1 * average_edge_length(clean)), statistical());
  double within = 0;
  for (std::size_t v = 0; v < r.kappa_max.size(); ++v) {
    const Vec3& p = clean.positions[v];
    const double angle = std::atan2(p.z, std::hypot(p.x, p.y) - 1);
    within += std::abs(r.kappa_max[v] - 2.5) < r.standard_error[v];
    within += std::abs(r.kappa_min[v] - torus_curvature_around_axis(1, 0.4, angle)) < r.standard_error[v];
  }
  EXPECT_GT(within / (2 * double(r.kappa_max.size())), 0.45);
  EXPECT_LT(within / (2 * double(r.kappa_max.size())), 0.9);
}

TEST(Statistical, ABoundaryOfACleanSurfaceIsNoWorseThanItsVerticesAllow)
{
  // Half of a torus whose tube is 4.4 edges wide: at its rim half a disc of vertices is all there is.
  TriangleMesh mesh = torus(1, 0.6, 48, 32);
  const auto is_outside = [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](int v) { return mesh.positions[std::size_t(v)].x < -1e-9; });
  };
  mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), is_outside), mesh.triangles.end());
  const Result r = compute_curvature(mesh, statistical());
  for (std::size_t v = 0; v < r.kappa_max.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    if (p.x < -1e-9) continue;
    const double around = torus_curvature_around_axis(1, 0.6, std::atan2(p.z, std::hypot(p.x, p.y) - 1));
    EXPECT_NEAR(r.kappa_max[v], 1 / 0.6, 0.2) << p.x;
    EXPECT_NEAR(r.kappa_min[v], around, 0.35) << p.x;
  }
}

TEST(Statistical, ACreaseIsNoSharperThanTheSmallestBallAndDoesNotRing)
{
  const TriangleMesh mesh = box(1, 1, 1, 0.05);
  const double edge = average_edge_length(mesh);
  const Result r = compute_curvature(mesh, statistical());
  for (std::size_t v = 0; v < r.kappa_max.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    double distances[] = {std::min(p.x, 1 - p.x), std::min(p.y, 1 - p.y), std::min(p.z, 1 - p.z)};
    std::sort(std::begin(distances), std::end(distances));
    if (distances[2] < 0.25) continue;  // near a corner
    EXPECT_GT(r.kappa_min[v] * edge, -0.05) << "beside the crease";
    EXPECT_LT(r.kappa_max[v] * edge, distances[1] < 0.12 ? 1.6 : 1e-6) << distances[1];
  }
}

TEST(Statistical, FlatFacesBesideACreaseStayFlatUnderNoise)
{
  const TriangleMesh clean = box(1, 1, 1, 0.04);
  const double edge = average_edge_length(clean);
  const Result r = compute_curvature(with_normal_noise(clean, 0.1 * edge), statistical());
  double sum = 0, count = 0;
  for (std::size_t v = 0; v < r.kappa_max.size(); ++v) {
    const Vec3& p = clean.positions[v];
    double distances[] = {std::min(p.x, 1 - p.x), std::min(p.y, 1 - p.y), std::min(p.z, 1 - p.z)};
    std::sort(std::begin(distances), std::end(distances));
    if (distances[1] < 3 * edge) continue;
    sum += std::abs(r.kappa_max[v]) + std::abs(r.kappa_min[v]);
    count += 2;
  }
  EXPECT_LT(sum / count * edge, 0.004);
}

// The other side of a wall cuts small balls by less than the noise can show, and thin walls have no smaller ones.
TEST(Statistical, BothSidesOfAThinWallKeepTheirCurvatureUnderNoise)
{
  const TriangleMesh outside = icosphere(5);
  const std::size_t n = outside.positions.size();
  const double edge = average_edge_length(outside);
  const struct {
    EngineKind engine;
    double wall, sigma;  // edges
  } cases[] = {{EngineKind::surface_integral, 1, 0.1},   {EngineKind::surface_integral, 1.4, 0.1},
               {EngineKind::surface_integral, 2, 0.3},   {EngineKind::surface_integral, 3, 0.1},
               {EngineKind::surface_integral, 4.5, 0.3}, {EngineKind::volume_fft, 3, 0.3}};
  for (const auto& [engine, wall, sigma] : cases) {
    const double inner_radius = 1 - wall * edge;
    const TriangleMesh inside = flipped(rotated(icosphere(5, inner_radius), {0, 0, 1}, 0.3));
    const auto noisy = [&, sigma = sigma](const TriangleMesh& mesh, std::uint32_t seed) {
      return with_normal_noise(with_tangential_jitter(mesh, 0.2 * edge), sigma * edge, seed);
    };
    Parameters p = statistical();
    p.engine = engine;
    const Result r = compute_curvature(joined(noisy(outside, 1), noisy(inside, 7)), p);
    double error = 0;
    for (std::size_t v = 0; v < 2 * n; ++v) {
      const double kappa = v < n ? 1 : -1 / inner_radius;
      error += (std::abs(r.kappa_max[v] - kappa) + std::abs(r.kappa_min[v] - kappa)) / std::abs(kappa);
    }
    EXPECT_LT(error / (4 * double(n)), 0.07) << "wall " << wall << " noise " << sigma;
  }
}

// The rim is a strip between two creases: the curvature along it is known well, that across it hardly; and under strong
// noise the smallest balls do not show that they are creases.
TEST(Statistical, TheRimOfACoinHasNoCurvatureAcrossUnderNoise)
{
  constexpr double edge = 1, radius = 40, pi = 3.14159265358979;
  struct Case {
    double height, sigma, across;
  };
  for (const Case& c : {Case{5, 0.1, 0.5}, Case{9, 0.2, 0.35}}) {
    const TriangleMesh clean = cylinder(radius, c.height, edge);
    const Result r = compute_curvature(with_normal_noise(clean, c.sigma * average_edge_length(clean)), statistical());
    double angles = 0, count = 0;
    std::vector<double> along, across;
    for (std::size_t v = 0; v < r.kappa_max.size(); ++v) {
      const Vec3& p = clean.positions[v];
      if (std::hypot(p.x, p.y) < radius - 1e-6 || c.height / 2 - std::abs(p.z) < 1.9) continue;
      const double cosine = std::abs(dot(r.dir_max[v], normalized({-p.y, p.x, 0})));
      angles += std::acos(std::min(1.0, cosine)) * 180 / pi;
      along.push_back(std::abs(r.kappa_max[v] * radius - 1));
      across.push_back(std::abs(r.kappa_min[v] * radius));
      ++count;
    }
    ASSERT_GT(count, 200);
    const auto median = [](std::vector<double>& x) {
      std::nth_element(x.begin(), x.begin() + std::ptrdiff_t(x.size() / 2), x.end());
      return x[x.size() / 2];
    };
    EXPECT_LT(angles / count, 7) << c.height;
    EXPECT_LT(median(along), 0.03) << c.height;
    EXPECT_LT(median(across), c.across) << c.height;
  }
}

// To the balls a rod no thicker than they are looks like a crease, but all over: creases are lines.
TEST(Statistical, ThinRodsAreNoCreasesUnderNoise)
{
  constexpr double pi = 3.14159265358979, axis_radius = 40;
  struct Case {
    double radius, sigma, largest_error;
  };
  for (const Case& c : {Case{2, 0.1, 0.06}, Case{3, 0.3, 0.15}, Case{5, 0.5, 0.13}}) {
    const TriangleMesh clean =
        torus(axis_radius, c.radius, int(2 * pi * axis_radius), int(std::lround(2 * pi * c.radius)));
    const Result r = compute_curvature(with_normal_noise(clean, c.sigma * average_edge_length(clean)), statistical());
    double error = 0;
    for (const double kappa : r.kappa_max) error += std::abs(kappa * c.radius - 1) / double(r.kappa_max.size());
    EXPECT_LT(error, c.largest_error) << "radius " << c.radius << " noise " << c.sigma;
  }
}

// A cylinder that ends in half spheres: one of its curvatures jumps, between vertices in no order.
TEST(Statistical, BesideAJumpOfTheCurvatureFitsKeepToTheirSideWithoutNoise)
{
  constexpr int around = 128, rings = 72;
  constexpr double pi = 3.14159265358979, spacing = 2 * pi / around, seam = 10.4 * spacing;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> jitter(-0.25, 0.25);
  TriangleMesh mesh;
  std::vector<double> along;
  for (int j = 0; j <= rings; ++j)
    for (int i = 0; i < around; ++i) {
      const double s = (j - rings / 2 + jitter(generator)) * spacing;
      const double angle = spacing * (i + 0.5 * (j % 2) + jitter(generator));
      along.push_back(std::abs(s));
      const double beyond = std::max(0.0, std::abs(s) - seam);
      const double z = std::copysign(std::min(std::abs(s), seam) + std::sin(beyond), s);
      mesh.positions.push_back({std::cos(beyond) * std::cos(angle), std::cos(beyond) * std::sin(angle), z});
    }
  for (int j = 0; j < rings; ++j)
    for (int i = 0; i < around; ++i) {
      const int next = (i + 1) % around, a = j * around + i, b = j * around + next, c = a + around, d = b + around;
      if (j % 2 == 0) mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {b, d, c}});
      if (j % 2 == 1) mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {a, d, c}});
    }
  const Result r = compute_curvature(mesh, statistical());
  double sum = 0, count = 0;
  for (std::size_t v = 0; v < along.size(); ++v) {
    const double s = along[v];
    if (s > seam + 8 * spacing) continue;  // near the end of the surface
    sum += std::abs(r.kappa_max[v] - 1) + std::abs(r.kappa_min[v] - (s > seam ? 1 : 0));
    ++count;
  }
  EXPECT_LT(sum / count, 0.007) << "0.014 with fits to all sides alone";
}

TEST(Statistical, ScalesWithTheMesh)
{
  const Result one = compute_curvature(noisy_sphere(0.1), statistical());
  const Result large = compute_curvature(scaled(noisy_sphere(0.1), 1024), statistical());
  for (std::size_t v = 0; v < one.kappa_max.size(); ++v)
    ASSERT_NEAR(large.kappa_max[v] * 1024, one.kappa_max[v], 1e-6 + 1e-4 * std::abs(one.kappa_max[v]));
}

TEST(Statistical, SameResultOnAnyNumberOfThreads)
{
  Parameters p = statistical();
  p.threads = 1;
  const Result one = compute_curvature(noisy_sphere(0.1), p);
  p.threads = 3;
  const Result three = compute_curvature(noisy_sphere(0.1), p);
  EXPECT_EQ(one.kappa_max, three.kappa_max);
  EXPECT_EQ(one.standard_error, three.standard_error);
}

TEST(Statistical, OtherEstimatorsAndRadii)
{
  Parameters p = statistical();
  p.estimator = Estimator::offset_free;
  EXPECT_LT(mean_error(compute_curvature(noisy_sphere(0.1), p), 1), 0.1);
  p.radius_choice = RadiusChoice::fixed;
  p.radius = 0.4;
  const double offset_free = mean_error(compute_curvature(noisy_sphere(0.1), p), 1);
  p.estimator = Estimator::yang06;
  EXPECT_LT(offset_free, mean_error(compute_curvature(noisy_sphere(0.1), p), 1));
  p.radius_choice = RadiusChoice::feature_adapted;
  p.estimator = Estimator::bias_free;
  EXPECT_LT(mean_error(compute_curvature(icosphere(4), p), 1), 0.01);
}

TEST(Statistical, RefusesWhatItCannotDo)
{
  Parameters p = statistical();
  p.estimator = Estimator::yang06;
  EXPECT_THROW(compute_curvature(icosphere(1), p), ParameterError);
  p = statistical();
  p.scales = 2;
  EXPECT_THROW(compute_curvature(icosphere(1), p), ParameterError);
}
