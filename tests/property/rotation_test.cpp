// SPDX-License-Identifier: GPL-3.0-or-later
// The default method does not see how the mesh lies in space.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "integral_invariant/curvature.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

const Vec3 axis = normalized({0.3, 0.5, -0.7});
constexpr double angle = 1.1;

/// Largest difference of either curvature, in average edges.
double largest_move(const Result& a, const Result& b)
{
  double largest = 0;
  for (std::size_t v = 0; v < a.kappa_max.size(); ++v)
    largest = std::max({largest, std::abs(a.kappa_max[v] - b.kappa_max[v]), std::abs(a.kappa_min[v] - b.kappa_min[v])});
  return largest * a.average_edge;
}

}  // namespace

TEST(Rotation, MovesNoCurvature)
{
  constexpr double rounding = 1e-5;  // tensors and signals are kept in single precision
  for (const TriangleMesh& mesh :
       {with_normal_noise(torus(2, 0.6, 120, 36), 0.005), bumpy_sphere(4), with_normal_noise(bumpy_sphere(4), 0.01)}) {
    const Result result = compute_curvature(mesh, {});
    EXPECT_LT(largest_move(result, compute_curvature(rotated(mesh, axis, angle), {})), rounding);
    EXPECT_LT(largest_move(result, compute_curvature(translated(mesh, {3, -2, 1}), {})), rounding);
  }
}

TEST(Rotation, TurnsDirectionsAndNormals)
{
  const TriangleMesh mesh = with_normal_noise(torus(2, 0.6, 120, 36), 0.005);
  const Result result = compute_curvature(mesh, {}), turned = compute_curvature(rotated(mesh, axis, angle), {});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_NEAR(dot(turned.normal[v], rotated(result.normal[v], axis, angle)), 1, 1e-10);
    // Directions have no sign.
    EXPECT_NEAR(std::abs(dot(turned.dir_max[v], rotated(result.dir_max[v], axis, angle))), 1, 1e-6);
    EXPECT_NEAR(std::abs(dot(turned.dir_min[v], rotated(result.dir_min[v], axis, angle))), 1, 1e-6);
  }
}
