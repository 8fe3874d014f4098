// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/mesh/canonical_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "integral_invariant/error.h"
#include "support/shapes.h"
#include "support/shuffle.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

TriangleMesh sample() { return with_normal_noise(torus(2, 0.6, 60, 18), 0.005); }

}  // namespace

TEST(CanonicalOrder, IsTheSameForAnyOrderOfTheCaller)
{
  const CanonicalMesh reference = make_canonical_mesh(sample());
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const ShuffledMesh other = shuffled(sample(), seed);
    const CanonicalMesh canonical = make_canonical_mesh(other.mesh);
    EXPECT_TRUE(canonical.mesh.positions == reference.mesh.positions);
    EXPECT_EQ(canonical.mesh.triangles, reference.mesh.triangles);
    for (std::size_t i = 0; i < reference.original_index.size(); ++i)
      EXPECT_EQ(canonical.original_index[i], std::uint32_t(other.place[reference.original_index[i]]));
  }
}

TEST(CanonicalOrder, HoldsTheSameMesh)
{
  const TriangleMesh mesh = sample();
  const CanonicalMesh canonical = make_canonical_mesh(mesh);
  ASSERT_EQ(canonical.mesh.positions.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    EXPECT_TRUE(canonical.mesh.positions[i] == mesh.positions[canonical.original_index[i]]);
  std::vector<Triangle> before, after;
  for (const Triangle& t : mesh.triangles) before.push_back(smallest_first(t));
  for (const Triangle& t : canonical.mesh.triangles) {
    const auto caller = [&](std::int32_t v) { return std::int32_t(canonical.original_index[std::size_t(v)]); };
    after.push_back(smallest_first({caller(t[0]), caller(t[1]), caller(t[2])}));
  }
  std::sort(before.begin(), before.end());
  std::sort(after.begin(), after.end());
  EXPECT_EQ(before, after);
}

TEST(CanonicalOrder, OfAMeshInsideOutIsThatOfItsRightSide)
{
  const CanonicalMesh straight = make_canonical_mesh(sample()), turned = make_canonical_mesh(flipped(sample()));
  EXPECT_EQ(straight.original_index, turned.original_index);
  ASSERT_EQ(straight.mesh.triangles.size(), turned.mesh.triangles.size());
  for (std::size_t t = 0; t < straight.mesh.triangles.size(); ++t) {
    Triangle back = turned.mesh.triangles[t];
    std::swap(back[1], back[2]);
    EXPECT_EQ(straight.mesh.triangles[t], back);
  }
}

TEST(CanonicalOrder, VerticesThatBoundNothingComeLast)
{
  TriangleMesh mesh{{{9, 9, 9}, {1, 0, 0}, {std::nan(""), 0, 0}, {0, 0, 0}, {0, 1, 0}},
                    {{1, 4, 3}, {1, 2, 3}, {0, 1, 1}}};
  const CanonicalMesh canonical = make_canonical_mesh(mesh);
  EXPECT_EQ(canonical.original_index[3], 0u);
  EXPECT_EQ(canonical.original_index[4], 2u);
  EXPECT_EQ(canonical.mesh.triangles.size(), 3u);
}

TEST(CanonicalOrder, VerticesAtOnePlaceAreOne)
{
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
                          {{4, 1, 2}, {0, 1, 2}, {3, 1, 2}, {0, 1, 3}, {1, 1, 2}}};
  const CanonicalMesh canonical = make_canonical_mesh(mesh);
  EXPECT_EQ(canonical.joined_vertices(), 2u);  // what no triangle uses stays on its own
  EXPECT_EQ(canonical.mesh.positions.size(), 4u);
  EXPECT_EQ(canonical.original_index.back(), 5u);
  EXPECT_EQ(canonical.vertex_of[0], canonical.vertex_of[3]);
  EXPECT_EQ(canonical.vertex_of[0], canonical.vertex_of[4]);
  EXPECT_EQ(canonical.original_index[canonical.vertex_of[4]], 0u);
  EXPECT_EQ(canonical.collapsed_triangles, 1u);
  EXPECT_EQ(canonical.mesh.triangles.size(), 4u);
}

TEST(CanonicalOrder, CoordinatesThatOverflowAreOrderedToo)
{
  for (const double size : {1e-320, 1e-200, 1e200, 1.7e308}) {
    const TriangleMesh mesh = scaled(icosphere(1), size);
    const ShuffledMesh other = shuffled(mesh, 1);
    EXPECT_EQ(make_canonical_mesh(mesh).original_index.size(), mesh.positions.size());
    EXPECT_TRUE(make_canonical_mesh(mesh).mesh.positions == make_canonical_mesh(other.mesh).mesh.positions) << size;
  }
}

TEST(CanonicalOrder, RefusesAnIndexOutOfRangeAsTheCallerHasIt)
{
  TriangleMesh mesh = shuffled(sample(), 1).mesh;
  mesh.triangles[5][1] = 12345;
  mesh.triangles[6][0] = -1;
  try {
    make_canonical_mesh(mesh);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("refers to vertex 12345, but the mesh has 1080 vertices"),
              std::string::npos);
  }
}

TEST(CanonicalOrder, OfNothingIsNothing) { EXPECT_TRUE(make_canonical_mesh({}).original_index.empty()); }
