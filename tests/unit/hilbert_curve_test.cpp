// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/mesh/hilbert_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace integral_invariant;

namespace {

/// Its cells are those of the integers.
HilbertCurve curve_of_integers()
{
  const double half = double(1U << (HilbertCurve::bits - 1));
  return {{half, half, half}, half};
}

std::vector<std::uint64_t> indices_along(const HilbertCurve& curve, const std::vector<Vec3>& points)
{
  Execution execution(1);
  return curve.indices(points, execution);
}

constexpr std::uint64_t end_of_curve = std::uint64_t(1) << 3 * HilbertCurve::bits;

}  // namespace

TEST(HilbertCurve, PassesEveryCellOnceFromNeighbourToNeighbour)
{
  // The first corner of the cube is passed first.
  constexpr int side = 16;
  std::vector<Vec3> places;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) places.push_back({x + 0.5, y + 0.5, z + 0.5});
  const std::vector<std::uint64_t> indices = indices_along(curve_of_integers(), places);
  std::vector<Vec3> along(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    ASSERT_LT(indices[i], places.size());
    ASSERT_EQ(norm(along[indices[i]]), 0) << "passed twice";
    along[indices[i]] = places[i];
  }
  for (std::size_t i = 1; i < along.size(); ++i) EXPECT_EQ(norm(along[i] - along[i - 1]), 1);
}

TEST(HilbertCurve, GoesThroughTheWholeCube)
{
  const double last = double((1U << HilbertCurve::bits) - 1);
  const std::vector<std::uint64_t> ends =
      indices_along(curve_of_integers(), {{0, 0, 0}, {last, 0, 0}, {last / 2, last / 2, last / 2}});
  EXPECT_EQ(ends[0], 0U);
  EXPECT_EQ(ends[1], end_of_curve - 1);
  EXPECT_LT(ends[2], end_of_curve / 8);
}

TEST(HilbertCurve, DoesNotDependOnHowManyPointsAreAsked)
{
  std::vector<Vec3> points;
  for (int i = 0; i < 21; ++i) points.push_back({i * 1234.5, i * i * 678.9, 1e6 / (i + 1)});
  const std::vector<std::uint64_t> all = indices_along(curve_of_integers(), points);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(indices_along(curve_of_integers(), {points[i]})[0], all[i]);
  EXPECT_TRUE(indices_along(curve_of_integers(), {}).empty());
}

TEST(HilbertCurve, PlacesOutsideTheCubeCountAsTheNearestCell)
{
  const HilbertCurve curve({1, 2, 3}, 0.5);
  const std::vector<std::uint64_t> indices =
      indices_along(curve, {{-9, -9, -9}, {0.5, 1.5, 2.5}, {9, 9, 9}, {1.5, 2.5, 3.5}});
  EXPECT_EQ(indices[0], indices[1]);
  EXPECT_EQ(indices[2], indices[3]);
  EXPECT_NE(indices[0], indices[2]);
}

TEST(HilbertCurve, TakesWhatIsNoNumber)
{
  const double none = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  for (const double half_side : {0.0, 1.0, 1e308, infinite})
    for (const std::uint64_t index :
         indices_along(HilbertCurve({}, half_side), {{1, 2, 3}, {none, 0, infinite}, {-infinite, 1e308, 0}}))
      EXPECT_LT(index, end_of_curve) << half_side;
}
