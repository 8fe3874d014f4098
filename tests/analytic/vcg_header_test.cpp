// SPDX-License-Identifier: GPL-3.0-or-later
// The VCG extension on mesh types of the test's own: no MeshLab, no Qt.
#include <gtest/gtest.h>

#include <vcg/complex/algorithms/update/curvature_integral_invariant.h>

#include <vcg/complex/complex.h>

#include "support/shapes.h"

namespace {

class Vertex;
class Face;
struct UsedTypes : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Face>::AsFaceType> {};
class Vertex : public vcg::Vertex<UsedTypes, vcg::vertex::Coord3d, vcg::vertex::CurvatureDird, vcg::vertex::Radiusf,
                                  vcg::vertex::BitFlags> {};
class Face : public vcg::Face<UsedTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>> {};
using Update = vcg::tri::UpdateCurvatureIntegralInvariant<Mesh>;

/// A sphere of radius 2, with deleted vertices and faces strewn between the others.
void fill_with_sphere(Mesh& m)
{
  const auto sphere = test_support::icosphere(4, 2);
  for (const auto& p : sphere.positions) {
    vcg::tri::Allocator<Mesh>::DeleteVertex(m, *vcg::tri::Allocator<Mesh>::AddVertex(m, Mesh::CoordType(9, 9, 9)));
    vcg::tri::Allocator<Mesh>::AddVertex(m, Mesh::CoordType(p.x, p.y, p.z));
  }
  for (const auto& t : sphere.triangles) {
    const size_t a = size_t(2 * t[0] + 1), b = size_t(2 * t[1] + 1), c = size_t(2 * t[2] + 1);
    vcg::tri::Allocator<Mesh>::DeleteFace(m, *vcg::tri::Allocator<Mesh>::AddFace(m, a, b, b));
    vcg::tri::Allocator<Mesh>::AddFace(m, a, b, c);
  }
}

Update::Params fixed_radius(double radius)
{
  Update::Params params;
  params.radius_choice = integral_invariant::RadiusChoice::fixed;
  params.radius = radius;
  return params;
}

int percent_seen = -1;
bool note_percent(const int percent, const char*) { return percent_seen = percent, true; }
bool stop(const int, const char*) { return false; }

}  // namespace

TEST(UpdateCurvatureIntegralInvariant, WritesAllFieldsAndAttributes)
{
  Mesh m;
  fill_with_sphere(m);
  const auto result = Update::Compute(m, fixed_radius(0.8), note_percent);
  EXPECT_GE(percent_seen, 0);
  EXPECT_EQ(result.kappa_max.size(), size_t(m.VN()));

  auto kmax = vcg::tri::Allocator<Mesh>::FindPerVertexAttribute<double>(m, "ii_kmax");
  auto dirmin = vcg::tri::Allocator<Mesh>::FindPerVertexAttribute<Mesh::CoordType>(m, "ii_dirmin");
  ASSERT_TRUE(vcg::tri::Allocator<Mesh>::IsValidHandle<double>(m, kmax));
  ASSERT_TRUE(vcg::tri::Allocator<Mesh>::IsValidHandle<Mesh::CoordType>(m, dirmin));
  for (const auto& v : m.vert)
    if (!v.IsD()) {
      EXPECT_NEAR(v.cK1() * 2, 1, 0.03);
      EXPECT_NEAR(v.cK2() * 2, 1, 0.03);
      EXPECT_GE(v.cK1(), v.cK2());
      EXPECT_NEAR(v.cPD1().Norm(), 1, 1e-12);
      EXPECT_NEAR(v.cPD1() * v.cPD2(), 0, 1e-12);
      EXPECT_NEAR(v.cPD1() * v.cP(), 0, 0.05);
      EXPECT_NEAR(v.cR(), 0.8, 1e-6);
      EXPECT_EQ(kmax[v], v.cK1());
      EXPECT_EQ(dirmin[v], v.cPD2());
    }
}

TEST(UpdateCurvatureIntegralInvariant, ReplacesAnAttributeOfAnotherType)
{
  Mesh m;
  fill_with_sphere(m);
  vcg::tri::Allocator<Mesh>::AddPerVertexAttribute<char>(m, "ii_kmax");
  Update::Compute(m, fixed_radius(0.8));
  auto kmax = vcg::tri::Allocator<Mesh>::FindPerVertexAttribute<double>(m, "ii_kmax");
  EXPECT_TRUE(vcg::tri::Allocator<Mesh>::IsValidHandle<double>(m, kmax));
}

TEST(UpdateCurvatureIntegralInvariant, LeavesTheMeshAloneWhenCancelledOrRefused)
{
  Mesh m;
  fill_with_sphere(m);
  for (auto& v : m.vert) v.K1() = 42;
  EXPECT_THROW(Update::Compute(m, fixed_radius(0.8), stop), integral_invariant::Cancelled);
  EXPECT_THROW(Update::Compute(m, fixed_radius(-1)), integral_invariant::ParameterError);
  for (const auto& v : m.vert) EXPECT_EQ(v.cK1(), 42);
  EXPECT_FALSE(vcg::tri::HasPerVertexAttribute(m, "ii_kmax"));
}
