// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/mesh/surface.h"

#include <gtest/gtest.h>

#include "integral_invariant/error.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

std::string refusal(const TriangleMesh& mesh)
{
  try {
    const Surface surface(mesh);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

}  // namespace

TEST(Surface, NormalisesToUnitAverageEdge)
{
  const TriangleMesh mesh = translated(torus(2, 0.7, 40, 20), {1e3, -1e3, 5});
  for (const double scale : {1e-20, 1e-6, 1.0, 1e6, 1e15}) {
    const Surface surface(scaled(mesh, scale));
    EXPECT_NEAR(surface.unit() / scale, average_edge_length(mesh), 1e-9);
    EXPECT_NEAR(surface.diagonal() * surface.unit() / scale, bounding_box_diagonal(mesh), 1e-9);
    EXPECT_NEAR(average_edge_length({surface.positions(), surface.triangles()}), 1, 1e-12);
    EXPECT_TRUE(surface.is_closed());
  }
}

TEST(Surface, NeighboursAreSortedAndUnique)
{
  const Surface surface(icosphere(2));
  std::size_t directed = 0;
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
    const auto begin = surface.neighbours().begin() + surface.neighbour_start()[v];
    const auto end = surface.neighbours().begin() + surface.neighbour_start()[v + 1];
    EXPECT_TRUE(end - begin == 5 || end - begin == 6);
    EXPECT_TRUE(std::is_sorted(begin, end));
    EXPECT_EQ(std::adjacent_find(begin, end), end);
    directed += end - begin;
  }
  EXPECT_EQ(directed, 2 * 480u);  // 30 · 4² edges
}

TEST(Surface, CountsWhatIsWrongAndRenumbersNothing)
{
  TriangleMesh mesh = icosphere(2);
  const std::size_t n = mesh.positions.size(), m = mesh.triangles.size();
  mesh.positions.push_back({0.1, 0.2, 0.3});                                                     // unreferenced
  mesh.positions.push_back({std::nan(""), 0, 0});                                                // not finite
  mesh.triangles.push_back(mesh.triangles[7]);                                                   // duplicate
  mesh.triangles.push_back({mesh.triangles[3][1], mesh.triangles[3][2], mesh.triangles[3][0]});  // rotated duplicate
  mesh.triangles.push_back({4, 4, 5});                                                           // repeated index
  mesh.triangles.push_back({0, 1, int(n) + 1});                                                  // not finite
  const Surface surface(mesh);
  EXPECT_EQ(surface.vertex_count(), n + 2);
  EXPECT_EQ(surface.triangles().size(), m);
  EXPECT_EQ(surface.report().duplicate_triangles, 2u);
  EXPECT_EQ(surface.report().left_out_triangles, 2u);
  EXPECT_EQ(surface.report().unreferenced_vertices, 2u);
  EXPECT_EQ(surface.report().nonfinite_vertices, 1u);
  EXPECT_TRUE(surface.is_closed());
  EXPECT_FALSE(surface.is_referenced(n));
}

TEST(Surface, FindsBoundaryAndInconsistentEdges)
{
  TriangleMesh open = icosphere(2);
  open.triangles.pop_back();
  EXPECT_EQ(Surface(open).report().boundary_edges, 3u);
  EXPECT_FALSE(Surface(open).is_closed());

  TriangleMesh twisted = icosphere(2);
  std::swap(twisted.triangles[0][1], twisted.triangles[0][2]);
  EXPECT_EQ(Surface(twisted).report().inconsistent_edges, 3u);
  EXPECT_EQ(Surface(twisted).report().boundary_edges, 0u);
  EXPECT_FALSE(Surface(twisted).is_closed());
}

TEST(Surface, TurnsAnInsideOutMeshAround)
{
  const TriangleMesh mesh = icosphere(2);
  const Surface straight(mesh), turned(flipped(mesh));
  EXPECT_FALSE(straight.report().inside_out);
  EXPECT_TRUE(turned.report().inside_out);
  EXPECT_EQ(straight.triangles(), turned.triangles());
}

TEST(Surface, DropsRepetitionsOfAClosedSurfaceAndKeepsThoseThatCloseIt)
{
  TriangleMesh twice = icosphere(1);
  const std::size_t m = twice.triangles.size();
  for (std::size_t i = 0; i < m; ++i) twice.triangles.push_back(twice.triangles[i]);
  EXPECT_EQ(Surface(twice).triangles().size(), m);

  // Two tetrahedra that overlap on the base (0, 2, 1), which is there twice: without one of them its edges are
  // unbalanced.
  TriangleMesh shared{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {}};
  for (const int apex : {3, 4}) {
    shared.triangles.push_back({0, 2, 1});
    shared.triangles.push_back({0, 1, apex});
    shared.triangles.push_back({1, 2, apex});
    shared.triangles.push_back({2, 0, apex});
  }
  const Surface surface(shared);
  EXPECT_EQ(surface.report().duplicate_triangles, 1u);
  EXPECT_EQ(surface.triangles().size(), 8u);
  EXPECT_TRUE(surface.is_closed());
}

TEST(Surface, RefusesWithASentence)
{
  EXPECT_NE(refusal({}).find("no faces"), std::string::npos);
  EXPECT_NE(refusal({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}).find("area"), std::string::npos);
  EXPECT_NE(refusal({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}}).find("area"), std::string::npos);
  EXPECT_NE(refusal({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}}).find("vertex 3"), std::string::npos);
  EXPECT_NE(refusal({{{0, 0, 0}, {1e308, 0, 0}, {-1e308, 1, 0}}, {{0, 1, 2}}}).find("too large"), std::string::npos);
  EXPECT_NE(refusal({{{0, 0, 0}, {1e-101, 0, 0}, {0, 1e-101, 0}}, {{0, 1, 2}}}).find("too small"), std::string::npos);
}

TEST(Surface, RefusesFacesTooFarApartForACoordinate)
{
  const TriangleMesh near{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(refusal(test_support::joined(near, test_support::translated(near, {1e9, 0, 0}))), "accepted");
  EXPECT_NE(refusal(test_support::joined(near, test_support::translated(near, {1e13, 0, 0}))).find("far apart"),
            std::string::npos);
}

TEST(Surface, SaysHowFarItsCoordinatesAreRounded)
{
  const TriangleMesh mesh = translated(torus(3, 1, 90, 30), {5e5, 5e6, 100});
  EXPECT_EQ(Surface(mesh).report().coordinate_step, std::ldexp(1.0, 22 - 52));  // 5·10⁶ is from 2²² to 2²³
}
