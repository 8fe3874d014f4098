// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes that break assumptions: finite answers, in bounds, for every vertex.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/engine_runs.h"
#include "support/polyhedron_oracle.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

constexpr double pi = 3.14159265358979323846;
const std::vector<double> radii = {0.4, 1, 2, 4, 8};

MomentTable expect_sensible(const TriangleMesh& mesh)
{
  const Surface surface(mesh);
  MomentTable table;
  for (const bool same_sheet : {true, false}) {
    Parameters parameters;
    parameters.same_sheet = same_sheet;
    table = surface_moments(surface, radii, parameters);
    for (const auto& vertex : table)
      for (std::size_t k = 0; k < radii.size(); ++k) {
        const BallMoments& m = vertex[k];
        const double r = radii[k], ball = 4 * pi / 3 * r * r * r;
        EXPECT_TRUE(m.volume >= 0 && m.volume <= ball);
        EXPECT_TRUE(is_finite(m.first) && norm(m.first) <= 10 * ball * r);
        EXPECT_TRUE(std::isfinite(m.second.trace()) && std::abs(m.second.trace()) < 10 * ball * r * r);
        EXPECT_TRUE(m.confidence >= 0 && m.confidence <= 1);
      }
  }
  return table;
}

TriangleMesh soup(const TriangleMesh& mesh)
{
  TriangleMesh out;
  for (const Triangle& t : mesh.triangles) {
    const int first = int(out.positions.size());
    for (const std::int32_t i : t) out.positions.push_back(mesh.positions[std::size_t(i)]);
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

TriangleMesh cone(int valence)
{
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0.5}};
  for (int i = 0; i < valence; ++i)
    mesh.positions.push_back({std::cos(2 * pi * i / valence), std::sin(2 * pi * i / valence), 0});
  for (int i = 0; i < valence; ++i) mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % valence});
  return mesh;
}

}  // namespace

TEST(SurfaceEngineBroken, UnweldedSoupIsTheWeldedMesh)
{
  const TriangleMesh welded = with_normal_noise(icosphere(3), 0.01);
  const MomentTable a = expect_sensible(welded), b = expect_sensible(soup(welded));
  for (std::size_t t = 0; t < welded.triangles.size(); t += 11)
    for (std::size_t k = 0; k < radii.size(); ++k)
      EXPECT_LT(moment_distance(b[3 * t][k], a[std::size_t(welded.triangles[t][0])][k], radii[k]), 1e-9);
}

TEST(SurfaceEngineBroken, OneTriangle)
{
  const MomentTable table = expect_sensible({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  for (const auto& vertex : table)
    for (std::size_t k = 0; k < radii.size(); ++k) {
      EXPECT_NEAR(vertex[k].volume / (2 * pi / 3 * std::pow(radii[k], 3)), 1, 1e-9);
      EXPECT_LT(vertex[k].confidence, 0.5);
    }
}

TEST(SurfaceEngineBroken, FlippedFacesLowerTheConfidence)
{
  TriangleMesh mesh = icosphere(3);
  std::mt19937 random(7);
  for (Triangle& t : mesh.triangles)
    if (random() % 2) std::swap(t[0], t[1]);
  const MomentTable table = expect_sensible(mesh);
  double sum = 0;
  for (const auto& vertex : table) sum += vertex[2].confidence;
  EXPECT_LT(sum / double(table.size()), 0.2);
}

TEST(SurfaceEngineBroken, CoincidentAndDoubleSided)
{
  const TriangleMesh sphere = icosphere(3);
  expect_sensible(joined(sphere, flipped(sphere)));
  expect_sensible(joined(sphere, sphere));
  expect_sensible(joined(sphere, icosphere(3, 0.999)));
}

TEST(SurfaceEngineBroken, BowTieVertexOfTwoSolids)
{
  const TriangleMesh a = icosphere(2);
  const Vec3 top = a.positions[0];
  expect_sensible(joined(a, translated(a, top * 2)));
}

TEST(SurfaceEngineBroken, VertexOnAnotherTrianglesEdge)
{
  // A flat square whose left half has one long edge where the right half has two: flat for all balls, rounding or not.
  for (const double rounding : {0.0, 1e-7, -1e-7}) {
    const TriangleMesh mesh{{{0, 0, 0}, {0, 2, 0}, {-2, 1, 0}, {rounding, 1, rounding}, {2, 1, 0}},
                            {{0, 1, 2}, {0, 4, 3}, {3, 4, 1}}};
    const MomentTable table = expect_sensible(mesh);
    for (std::size_t v = 0; v < table.size(); ++v)
      for (std::size_t k = 0; k < radii.size(); ++k)
        EXPECT_NEAR(table[v][k].volume / (2 * pi / 3 * std::pow(radii[k], 3)), 1, 1e-2)
            << v << " " << k << " " << rounding;
  }
}

TEST(SurfaceEngineBroken, SliversAndHoles)
{
  TriangleMesh mesh = with_tangential_jitter(icosphere(3), 0.12);
  mesh.triangles.erase(mesh.triangles.begin() + 100, mesh.triangles.begin() + 160);
  for (std::size_t i = 0; i < mesh.positions.size(); i += 2) mesh.positions[i].z *= 1e-9;
  expect_sensible(mesh);
}

TEST(SurfaceEngineBroken, HighValenceCone)
{
  const MomentTable table = expect_sensible(cone(20000));
  EXPECT_GT(table[0][0].confidence, 0.99);
}
