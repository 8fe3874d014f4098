// SPDX-License-Identifier: GPL-3.0-or-later
// The surface engine on solids whose ball moments are known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "support/engine_runs.h"
#include "support/exact_moments.h"
#include "support/polyhedron_oracle.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

constexpr double pi = 3.14159265358979323846;

Parameters exact()
{
  Parameters parameters;
  parameters.exactness = Exactness::exact;
  return parameters;
}

/// A ball about the origin holds its part in the octant, quadrant or half space of a box.
double share_of_box(const Vec3& p, const Vec3& size, double r)
{
  double share = 1;
  for (const auto& [x, s] : {std::pair{p.x, size.x}, {p.y, size.y}, {p.z, size.z}}) {
    if (x - r >= 0 && x + r <= s) continue;
    if (std::min(x, s - x) > 1e-9) return -1;  // cut off centre: not of this form
    share /= 2;
  }
  return share;
}

/// n × n squares of side 1 in the plane z = 0, normals up.
TriangleMesh flat_patch(int n)
{
  TriangleMesh mesh;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) mesh.positions.push_back({double(i), double(j), 0});
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  return mesh;
}

}  // namespace

TEST(SurfaceEngineAnalytic, FacesEdgesAndCornersOfABox)
{
  for (const double step : {0.25, 1.0}) {
    const Surface surface(box(2, 3, 4, step));
    const Vec3 size = Vec3{2, 3, 4} * (1 / surface.unit());
    const std::vector<double> radii = {0.5, 1, 1.4};
    const MomentTable table = surface_moments(surface, radii, exact());
    int checked = 0;
    for (std::size_t v = 0; v < table.size(); ++v)
      for (std::size_t k = 0; k < radii.size(); ++k) {
        const double r = radii[k], share = share_of_box(surface.positions()[v] + size * 0.5, size, r);
        if (share < 0) continue;
        ++checked;
        EXPECT_NEAR(table[v][k].volume / (4 * pi / 3 * r * r * r), share, 1e-11);
        EXPECT_NEAR(table[v][k].second.xx / (4 * pi / 15 * std::pow(r, 5)), share, 1e-11);
        EXPECT_EQ(table[v][k].confidence, 1);
      }
    EXPECT_GT(checked, 20);
  }
}

TEST(SurfaceEngineAnalytic, SphereConvergesToTwoBalls)
{
  const Surface surface(icosphere(5));
  const double big = 1 / surface.unit();
  const std::vector<double> radii = {2, 4, 8};
  const MomentTable table = surface_moments(surface, radii);
  for (std::size_t v = 0; v < table.size(); v += 501)
    for (std::size_t k = 0; k < radii.size(); ++k) {
      const double r = radii[k];
      const double volume = 2 * pi / 3 * r * r * r - pi * r * r * r * r / (4 * big);  // of two intersecting balls
      EXPECT_NEAR(table[v][k].volume / volume, 1, 0.012 / r);  // the inscribed mesh lies ē²/12R under the sphere
    }
}

TEST(SurfaceEngineAnalytic, FlatOpenPatchIsAHalfSpaceUpToItsRim)
{
  const Surface surface(flat_patch(12));
  const std::vector<double> radii = {1, 2.5, 4};
  for (const Exactness exactness : {Exactness::balanced, Exactness::exact}) {
    Parameters parameters;
    parameters.exactness = exactness;
    const MomentTable table = surface_moments(surface, radii, parameters);
    for (std::size_t v = 0; v < table.size(); ++v)
      for (std::size_t k = 0; k < radii.size(); ++k) {
        EXPECT_LT(moment_distance(table[v][k], half_space_moments({0, 0, 1}, radii[k]), radii[k]), 1e-12)
            << "vertex " << v << " scale " << k;
        EXPECT_LT(largest_curvature_times_radius(table[v][k], radii[k]), 1e-10);
      }
  }
}

TEST(SurfaceEngineAnalytic, ConfidenceIsTheShareOfTheSurface)
{
  const int n = 40;
  const Surface surface(flat_patch(n));
  const std::vector<double> radii = {3, 8};
  const MomentTable table = surface_moments(surface, radii);
  const auto at = [&](int i, int j) { return table[std::size_t(i * (n + 1) + j)]; };
  for (std::size_t k = 0; k < radii.size(); ++k) {
    EXPECT_NEAR(at(20, 20)[k].confidence, 1, 1e-12);
    EXPECT_NEAR(at(0, 20)[k].confidence, 0.5, 0.02);
    EXPECT_NEAR(at(0, 0)[k].confidence, 0.25, 0.02);
  }
  const double r = radii[1] * surface.unit(), d = 4, missing = r * r * std::acos(d / r) - d * std::sqrt(r * r - d * d);
  EXPECT_NEAR(at(4, 20)[1].confidence, 1 - missing / (pi * r * r), 0.02);
}
