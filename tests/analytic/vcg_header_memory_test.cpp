// SPDX-License-Identifier: GPL-3.0-or-later
// The VCG extension where memory runs out or the user stops it: the mesh has all results, or none and is as it was.
#include <gtest/gtest.h>

#include <vcg/complex/algorithms/update/curvature_integral_invariant.h>

#include <vcg/complex/complex.h>

#include "support/failing_allocation.h"
#include "support/shapes.h"

namespace {

class Vertex;
class Face;
struct UsedTypes : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Face>::AsFaceType> {};
class Vertex : public vcg::Vertex<UsedTypes, vcg::vertex::Coord3f, vcg::vertex::CurvatureDirf, vcg::vertex::Radiusf,
                                  vcg::vertex::BitFlags> {};
class Face : public vcg::Face<UsedTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>> {};
using Allocator = vcg::tri::Allocator<Mesh>;
using Update = vcg::tri::UpdateCurvatureIntegralInvariant<Mesh>;

constexpr float untouched = 42;
constexpr const char* names[] = {"ii_kmax",       "ii_kmin",   "ii_radius", "ii_error",
                                 "ii_confidence", "ii_dirmax", "ii_dirmin"};

/// A sphere that has an attribute of the user's, one of the results' names with another type, and one with the right
/// type.
void fill(Mesh& m)
{
  const auto sphere = test_support::icosphere(2);
  for (const auto& p : sphere.positions) Allocator::AddVertex(m, Mesh::CoordType(float(p.x), float(p.y), float(p.z)));
  for (const auto& t : sphere.triangles) Allocator::AddFace(m, size_t(t[0]), size_t(t[1]), size_t(t[2]));
  auto other = Allocator::AddPerVertexAttribute<char>(m, "ii_radius");
  auto same = Allocator::AddPerVertexAttribute<float>(m, "ii_error");
  Allocator::AddPerVertexAttribute<int>(m, "an attribute of the user's with a long name");
  for (auto& v : m.vert) {
    other[v] = 'x';
    same[v] = untouched;
    v.K1() = v.K2() = v.R() = untouched;
    v.PD1() = v.PD2() = Mesh::CoordType(untouched, 0, 0);
  }
}

void expect_untouched(Mesh& m)
{
  EXPECT_EQ(m.vert_attr.size(), 3u);
  auto other = Allocator::FindPerVertexAttribute<char>(m, "ii_radius");
  auto same = Allocator::FindPerVertexAttribute<float>(m, "ii_error");
  ASSERT_TRUE(Allocator::IsValidHandle(m, other) && Allocator::IsValidHandle(m, same));
  for (auto& v : m.vert) {
    ASSERT_EQ(other[v], 'x');
    ASSERT_EQ(same[v], untouched);
    ASSERT_TRUE(v.cK1() == untouched && v.cK2() == untouched && v.cR() == untouched);
    ASSERT_TRUE(v.cPD1()[0] == untouched && v.cPD2()[0] == untouched);
  }
}

void expect_complete(Mesh& m)
{
  EXPECT_EQ(m.vert_attr.size(), std::size(names) + 1);
  auto kmax = Allocator::FindPerVertexAttribute<float>(m, "ii_kmax");
  auto radius = Allocator::FindPerVertexAttribute<float>(m, "ii_radius");
  auto dirmin = Allocator::FindPerVertexAttribute<Mesh::CoordType>(m, "ii_dirmin");
  ASSERT_TRUE(Allocator::IsValidHandle(m, kmax) && Allocator::IsValidHandle(m, radius) &&
              Allocator::IsValidHandle(m, dirmin));
  for (auto& v : m.vert) {
    ASSERT_EQ(kmax[v], v.cK1());
    ASSERT_EQ(radius[v], v.cR());
    ASSERT_EQ(dirmin[v], v.cPD2());
    ASSERT_NE(v.cK1(), untouched);
  }
}

/// `action` with memory that ends at each allocation in turn, `next` leading from one to the next.
template <class Action, class Next>
void expect_all_or_nothing(Mesh& m, const Action& action, const Next& next)
{
  int refused = 0;
  for (long n = 1; test_support::runs_out_of_memory(n, action); n = next(n)) {
    ASSERT_NO_FATAL_FAILURE(expect_untouched(m)) << "at allocation " << n;
    ++refused;
  }
  EXPECT_GT(refused, 6);
  expect_complete(m);
}

int calls_left = 0;
bool stop_when_used_up(const int, const char*) { return --calls_left > 0; }

}  // namespace

TEST(VcgHeaderMemory, StoppedAtAnyCallOfTheCallbackNothingIsWritten)
{
  Mesh m;
  fill(m);
  int stopped = 0;
  for (int calls = 1;; ++calls) {
    calls_left = calls;
    try {
      Update::Compute(m, {}, stop_when_used_up);
      break;
    } catch (const integral_invariant::Cancelled&) {
      ASSERT_NO_FATAL_FAILURE(expect_untouched(m)) << "at call " << calls;
      ++stopped;
    }
  }
  EXPECT_GE(stopped, 5);  // one a stage at the least
  expect_complete(m);
}

TEST(VcgHeaderMemory, ComputeIsAllOrNothing)
{
  Mesh m;
  fill(m);
  Update::Params params;
  params.threads = 2;
  expect_all_or_nothing(
      m, [&] { Update::Compute(m, params); }, [](long n) { return 2 * n; });
}

TEST(VcgHeaderMemory, WritingIsAllOrNothingAtEveryAllocation)
{
  Mesh m;
  fill(m);
  const auto result = integral_invariant::compute_curvature(Update::CopyMesh(m), {});
  expect_all_or_nothing(
      m, [&] { Update::Write(m, result); }, [](long n) { return n + 1; });
}
