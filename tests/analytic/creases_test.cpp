// SPDX-License-Identifier: GPL-3.0-or-later
// Creases on a box, whose edges are known, and their absence on smooth shapes.
#include "integral_invariant/multiscale/creases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "integral_invariant/ball_curvature/ball_bias.h"
#include "integral_invariant/ball_curvature/offset_free.h"
#include "integral_invariant/moments/engine.h"
#include "integral_invariant/parameters.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

const std::vector<double> radii{1.5, 2.2255, 3.3019, 4.899};
constexpr double area_each = 0.87;

/// Creases of a mesh whose noise is known, σ in average edge lengths.
Creases creases_of(const Surface& surface, double sigma)
{
  Execution execution;
  execution.begin_stage("test", 100);
  TensorField tensors(surface.vertex_count(), radii);
  make_moment_engine(surface, Parameters{}, execution)
      ->evaluate(
          radii,
          [&](std::size_t v, int i, const BallMoments& m) {
            const OffsetFreeMeasure measure = offset_free_measure(m, radii[i]);
            tensors.set(v, i, correct_ball_bias(measure.tensor, radii[i], measure.offset, 0));
          },
          execution);
  NoiseLevel noise;
  noise.sigma.assign(surface.vertex_count(), sigma);
  noise.density.assign(surface.vertex_count(), area_each * sigma * sigma);
  return find_creases(surface, tensors, fit_jets(surface, tensors, execution), noise, {}, execution);
}

/// Distance of a point of the unit box to the nearest edge of it.
double distance_to_edge(const Vec3& p)
{
  double sides[] = {std::min(p.x, 1 - p.x), std::min(p.y, 1 - p.y), std::min(p.z, 1 - p.z)};
  std::sort(std::begin(sides), std::end(sides));
  return std::hypot(sides[0], sides[1]);
}

double distance_to_corner(const Vec3& p)
{
  return norm(Vec3{std::min(p.x, 1 - p.x), std::min(p.y, 1 - p.y), std::min(p.z, 1 - p.z)});
}

}  // namespace

TEST(Creases, EdgesOfABoxAreFoundUnderNoiseAndFacesAreNot)
{
  const TriangleMesh clean = box(1, 1, 1, 0.04);
  const double edge = average_edge_length(clean);
  for (const double sigma : {0.0, 0.1}) {
    const Creases creases = creases_of(Surface(with_normal_noise(clean, sigma * edge)), sigma);
    ASSERT_FALSE(creases.is_crease.empty());
    int missed = 0, edges = 0;
    for (std::size_t v = 0; v < clean.positions.size(); ++v) {
      const double away = distance_to_edge(clean.positions[v]) / edge;
      EXPECT_FALSE(away > 2 && creases.is_crease[v]) << away;
      if (away > 0.1 || distance_to_corner(clean.positions[v]) < 2 * edge) continue;
      ++edges;
      missed += !creases.is_crease[v];
    }
    EXPECT_LE(missed, edges / 100);
  }
}

TEST(Creases, DistancesAreThoseAlongTheSurfaceUpToTheLargestRadius)
{
  const TriangleMesh mesh = box(1, 1, 1, 0.04);
  const double edge = average_edge_length(mesh);
  const Creases creases = creases_of(Surface(mesh), 0);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double away = distance_to_edge(mesh.positions[v]) / edge, found = double(creases.distance[v]);
    if (creases.is_crease[v]) {
      EXPECT_EQ(found, 0);
    } else if (found < radii.back()) {
      EXPECT_NEAR(found, away, 2) << "creases are about an edge wide";
    } else {
      EXPECT_GT(away, radii.back() - 1);
    }
  }
}

TEST(Creases, SmoothShapesHaveNone)
{
  for (const double sigma : {0.0, 0.05, 0.2, 1.0})
    for (const TriangleMesh& clean : {icosphere(4), torus(1, 0.25, 96, 24)}) {
      const TriangleMesh noisy = with_normal_noise(clean, sigma * average_edge_length(clean));
      EXPECT_TRUE(creases_of(Surface(noisy), sigma).is_crease.empty()) << sigma;
    }
}
