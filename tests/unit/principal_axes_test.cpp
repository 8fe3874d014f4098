// SPDX-License-Identifier: GPL-3.0-or-later
// Axes that turn with the mesh and do not know its order.
#include "integral_invariant/mesh/principal_axes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "integral_invariant/support/orderless_sums.h"
#include "support/shapes.h"
#include "support/shuffle.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

Axes axes_of(const TriangleMesh& mesh)
{
  Execution execution(2);
  return principal_axes(mesh, execution);
}

bool are_same(const Axes& a, const Axes& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// Largest distance between the vertices of both meshes in coordinates along their own axes, from their first vertex.
double largest_distance(const TriangleMesh& a, const TriangleMesh& b)
{
  const Axes of_a = axes_of(a), of_b = axes_of(b);
  double largest = 0;
  for (std::size_t v = 0; v < a.positions.size(); ++v)
    largest = std::max(largest, norm(of_a.coordinates_of(a.positions[v] - a.positions[0]) -
                                     of_b.coordinates_of(b.positions[v] - b.positions[0])));
  return largest;
}

const Vec3 some_axis = normalized({0.3, 0.5, -0.7});

}  // namespace

TEST(OrderlessSums, AreTheSameInAnyOrderAndPrecise)
{
  const std::vector<double> terms{1, 1e-17, -0.3, 1e-3, 0.7, -1, 3e-18, 1e-9, -1e-3};
  OrderlessSums<1> forward(1, terms.size()), backward(1, terms.size()), halves(1, terms.size());
  for (const double term : terms) forward.add({term});
  for (std::size_t i = terms.size(); i-- > 0;) (i % 2 ? backward : halves).add({terms[i]});
  backward += halves;
  EXPECT_EQ(forward.values()[0], backward.values()[0]);
  EXPECT_NEAR(forward.values()[0], 0.4 + 1e-9 + 1.3e-17, 1e-16);
}

TEST(OrderlessSums, DoNotCancelWhatIsLeftOfLargeTerms)
{
  OrderlessSums<2> sums(1, 3);
  sums.add({1, 0});
  sums.add({1e-20, 0.25});
  sums.add({-1, 0.5});
  EXPECT_NEAR(sums.values()[0], 1e-20, 1e-26);
  EXPECT_EQ(sums.values()[1], 0.75);
}

TEST(PrincipalAxes, OfABoxAreItsSidesTheLongestFirst)
{
  const Axes axes = axes_of(rotated(box(1, 3, 2, 0.25), some_axis, 0.8));
  // All squares of the grid are cut the same way, so that the masses lie a little askew.
  EXPECT_NEAR(std::abs(dot(axes.x, rotated({0, 1, 0}, some_axis, 0.8))), 1, 1e-5);
  EXPECT_NEAR(std::abs(dot(axes.y, rotated({0, 0, 1}, some_axis, 0.8))), 1, 1e-5);
  EXPECT_NEAR(squared_norm(cross(axes.x, axes.y) - axes.z), 0, 1e-24);
}

TEST(PrincipalAxes, TurnWithTheMesh)
{
  for (const TriangleMesh& mesh : {bumpy_sphere(3), with_normal_noise(torus(2, 0.6, 60, 18), 0.005),
                                   translated(with_normal_noise(icosphere(3), 0.01), {100, 0, 7})})
    for (const double angle : {0.4, 1.7, 3.0})
      EXPECT_LT(largest_distance(mesh, rotated(mesh, some_axis, angle)), 1e-9) << angle;
}

TEST(PrincipalAxes, FindACornerWhereAllAreAlike)
{
  const TriangleMesh cube = translated(box(1, 1, 1, 1), {-0.5, -0.5, -0.5});
  for (const double angle : {0.0, 1.0, 2.5}) {
    const TriangleMesh turned = rotated(cube, some_axis, angle);
    const Vec3 diagonal = axes_of(turned).x;
    double nearest = 0;
    for (const Vec3& corner : turned.positions) nearest = std::max(nearest, dot(diagonal, normalized(corner)));
    EXPECT_NEAR(nearest, 1, 1e-12) << angle;
  }
}

TEST(PrincipalAxes, OfATorusLeadToItsAxisAndAVertex)
{
  const Axes axes = axes_of(rotated(torus(2, 0.6, 60, 18), some_axis, 1));
  EXPECT_NEAR(std::abs(dot(axes.x, rotated({0, 0, 1}, some_axis, 1))), 1, 1e-12);
}

TEST(PrincipalAxes, AreTheSameBitsInAnyOrderAndOfCopies)
{
  for (const TriangleMesh& mesh : {icosphere(3), torus(2, 0.6, 60, 18), with_normal_noise(icosphere(3), 0.01)}) {
    const Axes axes = axes_of(mesh);
    EXPECT_TRUE(are_same(axes, axes_of(shuffled(mesh, 5).mesh)));
    EXPECT_TRUE(are_same(axes, axes_of(flipped(mesh))));
    EXPECT_TRUE(are_same(axes, axes_of(soup(mesh).mesh)));
  }
}

TEST(PrincipalAxes, OfWhatHasNoAreaAreThoseOfSpace)
{
  const double huge = std::numeric_limits<double>::max();
  EXPECT_TRUE(are_same(axes_of({}), {}));
  EXPECT_TRUE(are_same(axes_of({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}}), {}));
  EXPECT_TRUE(are_same(axes_of({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}), {}));
  EXPECT_TRUE(are_same(axes_of({{{-huge, 0, 0}, {huge, 0, 0}, {0, huge, 0}}, {{0, 1, 2}}}), {}));
  EXPECT_TRUE(are_same(axes_of({{{0, 0, 0}, {1, 0, 0}, {std::nan(""), 1, 0}}, {{0, 1, 2}}}), {}));
}
