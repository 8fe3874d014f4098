// SPDX-License-Identifier: GPL-3.0-or-later
// The surface engine against the full polyhedron.
#include <gtest/gtest.h>

#include "support/engine_runs.h"
#include "support/polyhedron_oracle.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

double worst_distance(const TriangleMesh& mesh, const std::vector<double>& radii, std::size_t stride)
{
  const Surface surface(mesh);
  Parameters parameters;
  parameters.exactness = Exactness::exact;
  const auto all = surface_moments(surface, radii, parameters);
  const TriangleMesh normalised{surface.positions(), surface.triangles()};
  double worst = 0;
  for (std::size_t v = 0; v < all.size(); v += stride)
    for (std::size_t k = 0; k < radii.size(); ++k) {
      const BallMoments exact = polyhedron_moments(normalised, surface.positions()[v], radii[k]);
      const double distance = moment_distance(all[v][k], exact, radii[k]);
      EXPECT_LT(distance, 1e-9) << "vertex " << v << " radius " << radii[k];
      worst = std::max(worst, distance);
    }
  return worst;
}

const std::vector<double> radii = {0.3, 1, 2, 3.3, 5, 8};

}  // namespace

TEST(SurfaceEngineOracle, SmoothTorus) { EXPECT_LT(worst_distance(torus(1, 0.4, 40, 24), radii, 197), 1e-9); }

TEST(SurfaceEngineOracle, NoisyIrregularTorus)
{
  TriangleMesh mesh = torus(1, 0.4, 40, 24);
  const double edge = average_edge_length(mesh);
  for (const double sigma : {0.1, 0.5})
    EXPECT_LT(worst_distance(with_normal_noise(with_tangential_jitter(mesh, 0.4 * edge), sigma * edge), radii, 197),
              1e-9);
}

TEST(SurfaceEngineOracle, LargeTriangles)
{
  TriangleMesh cube = box(1, 1, 1, 1);
  EXPECT_LT(worst_distance(cube, {0.1, 0.3, 0.5, 0.7, 0.9, 1, 1.5, 2, 3}, 1), 1e-9);
  EXPECT_LT(worst_distance(icosphere(0), {0.1, 0.3, 0.5, 0.7, 0.9, 1, 1.2, 1.5, 2, 3}, 1), 1e-9);
}
