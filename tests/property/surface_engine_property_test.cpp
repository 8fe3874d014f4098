// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for the surface engine on any mesh.
#include <gtest/gtest.h>

#include <cmath>

#include "integral_invariant/ball_curvature/curvature_tensor.h"
#include "support/engine_runs.h"
#include "support/polyhedron_oracle.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

const std::vector<double> radii = {1, 2, 3, 4, 5, 6, 7, 8};

TriangleMesh noisy_torus(double noise)
{
  const TriangleMesh mesh = torus(1, 0.4, 80, 44);
  const double edge = average_edge_length(mesh);
  return with_normal_noise(with_tangential_jitter(mesh, 0.35 * edge), noise * edge);
}

double worst(const MomentTable& a, const MomentTable& b)
{
  double distance = 0;
  for (std::size_t v = 0; v < a.size(); ++v)
    for (std::size_t k = 0; k < radii.size(); ++k)
      distance = std::max(distance, moment_distance(a[v][k], b[v][k], radii[k]));
  return distance;
}

/// RMS over the vertices of the difference of both curvatures, relative to their RMS.
double curvature_error(const MomentTable& got, const MomentTable& truth, std::size_t k,
                       const std::vector<double>& at = radii)
{
  double error = 0, square = 0;
  for (std::size_t v = 0; v < got.size(); ++v) {
    const PrincipalCurvatures a = principal_curvatures(curvature_tensor(got[v][k], at[k]));
    const PrincipalCurvatures b = principal_curvatures(curvature_tensor(truth[v][k], at[k]));
    error += std::pow(a.kappa_max - b.kappa_max, 2) + std::pow(a.kappa_min - b.kappa_min, 2);
    square += std::pow(b.kappa_max, 2) + std::pow(b.kappa_min, 2);
  }
  return std::sqrt(error / square);
}

}  // namespace

TEST(SurfaceEngineProperty, BalancedIsWithinOnePercentOfExact)
{
  for (const double noise : {0.1, 0.5}) {
    const Surface surface(noisy_torus(noise));
    Parameters parameters;
    const MomentTable balanced = surface_moments(surface, radii, parameters);
    parameters.exactness = Exactness::fast;
    const MomentTable fast = surface_moments(surface, radii, parameters);
    parameters.exactness = Exactness::exact;
    const MomentTable exact = surface_moments(surface, radii, parameters);
    for (std::size_t k = 0; k < radii.size(); ++k) {
      EXPECT_LT(curvature_error(balanced, exact, k), k == 0 ? 0.03 : 0.01)
          << "noise " << noise << " radius " << radii[k];
      EXPECT_LT(curvature_error(fast, exact, k), k == 0 ? 0.05 : 0.01) << "noise " << noise << " radius " << radii[k];
    }
  }
}

TEST(SurfaceEngineProperty, SameBitsForAnyNumberOfThreads)
{
  const Surface surface(noisy_torus(0.2));
  Parameters parameters;
  parameters.threads = 1;
  const MomentTable one = surface_moments(surface, radii, parameters);
  for (const int threads : {2, 5}) {
    parameters.threads = threads;
    EXPECT_EQ(worst(one, surface_moments(surface, radii, parameters)), 0) << threads;
  }
}

TEST(SurfaceEngineProperty, FollowsRotationsAndScale)
{
  const TriangleMesh mesh = noisy_torus(0.2);
  const Vec3 axis = normalized({1, -2, 0.5});
  Parameters parameters;
  parameters.exactness = Exactness::exact;
  const MomentTable one = surface_moments(Surface(mesh), radii, parameters);
  const Surface moved(scaled(translated(rotated(mesh, axis, 1.1), {30, -20, 5}), 1e-4));
  const MomentTable other = surface_moments(moved, radii, parameters);
  for (std::size_t v = 0; v < one.size(); ++v)
    for (std::size_t k = 0; k < radii.size(); ++k) {
      EXPECT_NEAR(one[v][k].volume, other[v][k].volume, 1e-9 * std::pow(radii[k], 3));
      EXPECT_LT(norm(rotated(one[v][k].first, axis, 1.1) - other[v][k].first), 1e-9 * std::pow(radii[k], 4));
    }
}

TEST(SurfaceEngineProperty, DistantSheetsAddUp)
{
  // A ball that holds parts of two solids: the sum of what each gives, the other one's by the oracle.
  const TriangleMesh a = icosphere(3), b = translated(icosphere(3, 0.8), {1.95, 0, 0});
  const Surface surface(joined(a, b));
  Parameters parameters;
  parameters.exactness = Exactness::exact;
  const MomentTable table = surface_moments(surface, radii, parameters);
  const TriangleMesh all{surface.positions(), surface.triangles()};
  for (std::size_t v = 0; v < a.positions.size(); v += 37)
    for (const std::size_t k : {std::size_t(1), std::size_t(6)})
      EXPECT_LT(moment_distance(table[v][k], polyhedron_moments(all, surface.positions()[v], radii[k]), radii[k]),
                1e-9);
}

TEST(SurfaceEngineProperty, SameSheetSeesOneSideOfAThinPlate)
{
  const double thickness = 0.05;
  const TriangleMesh plate = box(2, 2, thickness, thickness);
  Parameters parameters;
  parameters.same_sheet = true;
  const Surface surface(plate);
  const std::vector<double> few = {1, 2, 3, 4};
  const MomentTable own = surface_moments(surface, few, parameters);
  parameters.same_sheet = false;
  const MomentTable both = surface_moments(surface, few, parameters);
  const double pi = 3.14159265358979323846;
  int checked = 0;
  for (std::size_t v = 0; v < own.size(); ++v) {
    const Vec3 p = surface.positions()[v] * surface.unit();
    if (std::max(std::abs(p.x), std::abs(p.y)) > 0.6 || std::abs(p.z) < 0.4 * thickness) continue;
    ++checked;
    for (std::size_t k = 0; k < few.size(); ++k)
      EXPECT_NEAR(own[v][k].volume / (2 * pi / 3 * std::pow(few[k], 3)), 1, 1e-9);
    EXPECT_LT(both[v][3].volume / (2 * pi / 3 * std::pow(few[3], 3)), 0.5);
  }
  EXPECT_GT(checked, 100);
}

TEST(SurfaceEngineProperty, DistantTrianglesAreSummedWithoutLoss)
{
  // Wide gaps between radii: most triangles lie between the same two spheres for a whole block.
  const Surface surface(noisy_torus(0.1));
  const std::vector<double> wide = {1, 5, 12, 30};
  Parameters parameters;
  parameters.exactness = Exactness::exact;
  const MomentTable summed = surface_moments(surface, wide, parameters);
  parameters.same_sheet = true;  // connected: the same surface, but triangle by triangle
  const MomentTable single = surface_moments(surface, {1}, parameters);
  const TriangleMesh mesh{surface.positions(), surface.triangles()};
  for (std::size_t v = 0; v < summed.size(); v += 701) {
    EXPECT_LT(moment_distance(summed[v][0], single[v][0], 1), 1e-12);
    EXPECT_LT(moment_distance(summed[v][3], polyhedron_moments(mesh, surface.positions()[v], 30), 30), 1e-6);
  }
}

TEST(SurfaceEngineProperty, LargeBallsAreWithinOnePercentOfExact)
{
  const std::vector<double> wide = {2, 4.5, 9, 16, 32};
  for (const double noise : {0.1, 0.5}) {
    const TriangleMesh mesh = torus(1, 0.4, 130, 72);
    const double edge = average_edge_length(mesh);
    const Surface surface(with_normal_noise(with_tangential_jitter(mesh, 0.35 * edge), noise * edge));
    Parameters parameters = published_method();
    const MomentTable balanced = surface_moments(surface, wide, parameters);
    parameters.exactness = Exactness::exact;
    const MomentTable exact = surface_moments(surface, wide, parameters);
    // The largest ball holds most of the torus, and somewhere the normal is one of two eigenvectors that are about as
    // good: there the curvature jumps with the last digits of the moments.
    for (std::size_t k = 0; k < wide.size(); ++k)
      EXPECT_LT(curvature_error(balanced, exact, k, wide), wide[k] < 32 ? 0.01 : 0.015)
          << noise << " radius " << wide[k];
  }
}

TEST(SurfaceEngineProperty, PointsBeyondTheClosedFormsKnowShapeAndKink)
{
  // Where curvature is small, an error of the moments shows most.
  const std::vector<double> wide = {3, 3.4, 4, 5, 6, 8, 11};
  for (const double noise : {0.0, 0.1, 0.5}) {
    const TriangleMesh mesh = bumpy_sphere(5);
    const double edge = average_edge_length(mesh);
    const Surface surface(with_normal_noise(with_tangential_jitter(mesh, 0.35 * edge), noise * edge));
    Parameters comparing;
    const MomentTable among_scales = surface_moments(surface, wide, comparing);
    const MomentTable by_itself = surface_moments(surface, wide, published_method());
    comparing.exactness = Exactness::exact;
    const MomentTable exact = surface_moments(surface, wide, comparing);
    for (std::size_t k = 0; k < wide.size(); ++k) {
      EXPECT_LT(curvature_error(among_scales, exact, k, wide), 0.003) << noise << " radius " << wide[k];
      EXPECT_LT(curvature_error(by_itself, exact, k, wide), 0.01) << noise << " radius " << wide[k];
    }
  }
}

TEST(SurfaceEngineProperty, LargeBallsKnowHolesAndTheirConfidence)
{
  // Holes near and far from the centres, all within the largest balls.
  TriangleMesh mesh = noisy_torus(0.1);
  std::vector<Triangle> kept;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (i % 600 > 12) kept.push_back(mesh.triangles[i]);
  mesh.triangles = kept;
  const Surface surface(mesh);
  Parameters parameters = published_method();
  const MomentTable balanced = surface_moments(surface, radii, parameters);
  parameters.exactness = Exactness::exact;
  const MomentTable exact = surface_moments(surface, radii, parameters);
  for (std::size_t k = 0; k < radii.size(); ++k) {
    EXPECT_LT(curvature_error(balanced, exact, k), k == 0 ? 0.03 : 0.01) << radii[k];
    for (std::size_t v = 0; v < exact.size(); ++v)
      EXPECT_NEAR(balanced[v][k].confidence, exact[v][k].confidence, 1e-9) << v << " radius " << radii[k];
  }
}

TEST(SurfaceEngineProperty, LargeBallsSeeBothSidesOfAThinPlate)
{
  const double thickness = 0.05;
  const Surface surface(box(2, 2, thickness, thickness));
  const std::vector<double> wide = {2, 6, 15, 40};
  Parameters parameters = published_method();
  const MomentTable balanced = surface_moments(surface, wide, parameters);
  parameters.exactness = Exactness::exact;
  const MomentTable exact = surface_moments(surface, wide, parameters);
  for (std::size_t v = 0; v < exact.size(); v += 17)
    for (std::size_t k = 0; k < wide.size(); ++k)
      EXPECT_LT(moment_distance(balanced[v][k], exact[v][k], wide[k]), 2e-3) << v << " radius " << wide[k];
}
