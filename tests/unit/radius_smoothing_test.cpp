// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/published/radius_smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "support/shapes.h"

using namespace integral_invariant;

namespace {

/// [Lai09 eq. 9] in the caller's units, straight from the triangles.
std::vector<double> direct_sum(const TriangleMesh& mesh, const std::vector<double>& r)
{
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
  double length = 0, difference = 0;
  for (const auto& [a, b] : edges) {
    length += norm(mesh.positions[a] - mesh.positions[b]) / double(edges.size());
    difference += std::abs(r[a] - r[b]) / double(edges.size());
  }
  std::vector<double> sum = r, weights(r.size(), 1);
  const auto add = [&](int a, int b) {
    const double d = norm(mesh.positions[a] - mesh.positions[b]) / length, dr = (r[a] - r[b]) / difference;
    const double w = std::exp(-d * d / 2 - dr * dr / 2);
    sum[a] += w * r[b];
    weights[a] += w;
  };
  for (const auto& [a, b] : edges) add(a, b), add(b, a);
  for (std::size_t v = 0; v < r.size(); ++v) sum[v] /= weights[v];
  return sum;
}

}  // namespace

TEST(SmoothRadii, EqualsTheDirectSum)
{
  const TriangleMesh mesh = test_support::with_tangential_jitter(test_support::icosphere(3, 5), 0.1);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(1, 8);
  std::vector<double> radii(mesh.positions.size());
  for (double& r : radii) r = uniform(generator);

  Execution execution(2);
  const auto once = smooth_radii(Surface(mesh), radii, 1, execution);
  const auto twice = smooth_radii(Surface(mesh), radii, 2, execution);
  const auto expected_once = direct_sum(mesh, radii), expected_twice = direct_sum(mesh, expected_once);
  for (std::size_t v = 0; v < radii.size(); ++v) {
    EXPECT_NEAR(once[v], expected_once[v], 1e-10);
    EXPECT_NEAR(twice[v], expected_twice[v], 1e-10);
  }
}

TEST(SmoothRadii, KeepsAConstantRadiusAndZeroPassesChangeNothing)
{
  const Surface surface(test_support::icosphere(2));
  Execution execution(1);
  const std::vector<double> constant(surface.vertex_count(), 3.0);
  EXPECT_EQ(smooth_radii(surface, constant, 3, execution), constant);
  std::vector<double> ramp(surface.vertex_count());
  for (std::size_t v = 0; v < ramp.size(); ++v) ramp[v] = 1 + double(v);
  EXPECT_EQ(smooth_radii(surface, ramp, 0, execution), ramp);
}
