// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices at one place are one vertex: meshes whose triangles share places, but not vertices, have the results of the
// welded mesh, at every copy.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "integral_invariant/curvature.h"
#include "integral_invariant/features/signature.h"
#include "integral_invariant/mesh/coordinate_step.h"
#include "support/shapes.h"
#include "support/shuffle.h"
#include "support/single_precision.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

TriangleMesh sample() { return with_normal_noise(torus(3, 1, 90, 30), 0.02); }

/// Every coordinate changed by up to `steps` steps of single precision at the size of the mesh.
TriangleMesh with_float_steps(TriangleMesh mesh, int steps)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<int> of(-steps, steps);
  const double step = coordinate_step(mesh.positions);
  for (Vec3& p : mesh.positions) p += Vec3{double(of(random)), double(of(random)), double(of(random))} * step;
  return in_single_precision(std::move(mesh));
}

TriangleMesh with_decimals(TriangleMesh mesh, double step)
{
  for (Vec3& p : mesh.positions)
    p = {std::round(p.x / step) * step, std::round(p.y / step) * step, std::round(p.z / step) * step};
  return mesh;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, std::abs(a[v] - b[v]));
  return largest;
}

}  // namespace

TEST(Seams, ASoupHasTheBitsOfTheWeldedMeshAtEveryCopy)
{
  for (const Parameters& parameters : {Parameters(), published_method()}) {
    const TriangleMesh mesh = sample();
    const Soup apart = soup(mesh);
    const Result expected = compute_curvature(mesh, parameters, {}),
                 result = compute_curvature(apart.mesh, parameters, {});
    EXPECT_EQ(result.kappa_max, apart.copies(expected.kappa_max));
    EXPECT_EQ(result.kappa_min, apart.copies(expected.kappa_min));
    EXPECT_EQ(result.radius, apart.copies(expected.radius));
    EXPECT_EQ(result.standard_error, apart.copies(expected.standard_error));
    EXPECT_EQ(result.confidence, apart.copies(expected.confidence));
    EXPECT_TRUE(result.dir_max == apart.copies(expected.dir_max));
    EXPECT_TRUE(result.dir_min == apart.copies(expected.dir_min));
    EXPECT_TRUE(result.normal == apart.copies(expected.normal));
    EXPECT_EQ(result.surface.vertices, apart.mesh.positions.size());
    EXPECT_EQ(result.surface.joined_vertices, apart.mesh.positions.size() - mesh.positions.size());
    EXPECT_EQ(result.surface.boundary_edges, 0u);
    EXPECT_EQ(expected.surface.joined_vertices, 0u);
  }
}

TEST(Seams, ASignatureIsTheSameAtEveryCopy)
{
  const TriangleMesh mesh = sample();
  const Soup apart = soup(mesh);
  const Signature expected = compute_signature(mesh, {}), result = compute_signature(apart.mesh, {});
  for (int quantity = 0; quantity < signature_quantity_count; ++quantity)
    for (std::size_t scale = 0; scale < expected.radii.size(); ++scale)
      EXPECT_EQ(result.values[quantity][scale], apart.copies(expected.values[quantity][scale]));
  EXPECT_EQ(result.surface.joined_vertices, apart.mesh.positions.size() - mesh.positions.size());
}

TEST(Seams, CopiesThatRoundingTookApartAreJoined)
{
  const TriangleMesh mesh = in_single_precision(sample());
  Soup apart = soup(mesh);
  apart.mesh = with_float_steps(std::move(apart.mesh), 2);
  const Result expected = compute_curvature(mesh, {}, {}), result = compute_curvature(apart.mesh, {}, {});
  EXPECT_EQ(result.surface.joined_vertices, apart.mesh.positions.size() - mesh.positions.size());
  EXPECT_EQ(result.surface.boundary_edges, 0u);
  constexpr double rounding = 1e-3;  // of a curvature about 1
  EXPECT_LT(largest_difference(result.kappa_max, apart.copies(expected.kappa_max)), rounding);
  EXPECT_LT(largest_difference(result.kappa_min, apart.copies(expected.kappa_min)), rounding);
}

TEST(Seams, CopiesInDecimalsAreJoinedWithinTheirLastDigits)
{
  constexpr double step = 1e-4;
  const TriangleMesh mesh = sample();
  Soup apart = soup(mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> off(-step, step);
  for (Vec3& p : apart.mesh.positions) p += Vec3{off(random), off(random), off(random)};
  const Result result = compute_curvature(with_decimals(apart.mesh, step), {}, {});
  EXPECT_EQ(result.surface.joined_vertices, apart.mesh.positions.size() - mesh.positions.size());
  EXPECT_EQ(result.surface.boundary_edges, 0u);
}

TEST(Seams, WhatIsApartByMoreThanRoundingStaysApart)
{
  // Every triangle a millionth off the one before: far under the edges, and far above the step of double precision.
  Soup apart = soup(icosphere(3));
  for (std::size_t v = 0; v < apart.mesh.positions.size(); ++v) apart.mesh.positions[v].x += 1e-6 * double(v / 3);
  EXPECT_EQ(compute_curvature(apart.mesh, {}, {}).surface.joined_vertices, 0u);
}

TEST(Seams, ALatticeAsWideAsTheEdgesJoinsNothing)
{
  TriangleMesh mesh = box(4, 3, 2, 1);  // whole numbers: a step is an edge
  mesh.triangles.resize(mesh.triangles.size() - 7);
  EXPECT_EQ(compute_curvature(mesh, {}, {}).surface.joined_vertices, 0u);
}

TEST(Seams, StepIsThatOfThePrecisionThatTheCoordinatesFill)
{
  const TriangleMesh mesh = sample();  // up to 4
  EXPECT_EQ(coordinate_step(mesh.positions), std::ldexp(1.0, -50));
  EXPECT_EQ(coordinate_step(in_single_precision(mesh).positions), std::ldexp(1.0, -21));
  EXPECT_NEAR(coordinate_step(with_decimals(mesh, 1e-5).positions), 1e-5, 1e-9);
  EXPECT_NEAR(coordinate_step(in_single_precision(with_decimals(mesh, 1e-4)).positions), 1e-4, 1e-8);
  EXPECT_EQ(coordinate_step({}), 0);
}
