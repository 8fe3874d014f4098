// SPDX-License-Identifier: GPL-3.0-or-later
// The confidence of the default method: how much of the ball's surface was there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "integral_invariant/curvature.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

TriangleMesh half_torus()
{
  TriangleMesh mesh = with_normal_noise(torus(2, 0.6, 100, 30), 0.005);
  mesh.triangles.resize(mesh.triangles.size() / 2);
  return mesh;
}

}  // namespace

TEST(Confidence, IsOneOnWhatIsClosedAlsoWhereDiscsReplaceBalls)
{
  for (const TriangleMesh& mesh : {box(2, 1.5, 1, 0.1), icosphere(3), torus(2, 0.6, 100, 30)}) {
    const Result r = compute_curvature(mesh, {});
    EXPECT_EQ(*std::min_element(r.confidence.begin(), r.confidence.end()), 1);
  }
}

TEST(Confidence, IsTheShareOfTheDiscThatABorderLeaves)
{
  const TriangleMesh mesh = half_torus();
  const Result r = compute_curvature(mesh, {});
  std::size_t on_border = 0, far = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    if (r.confidence[v] == 0) continue;     // of the half that was taken away
    const double distance = std::abs(p.y);  // from the planes of both borders, which lie in y = 0
    if (distance < 1e-2) {
      EXPECT_NEAR(r.confidence[v], 0.5, 0.1);
      ++on_border;
    } else if (distance > 1.1 * r.radius[v] + 0.15) {
      EXPECT_GT(r.confidence[v], 0.95);
      ++far;
    }
  }
  EXPECT_GT(on_border, 50u);
  EXPECT_GT(far, 100u);
}
