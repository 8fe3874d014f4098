// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/moments/fft/scan_conversion.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

std::vector<std::uint32_t> all_triangles(const Surface& surface)
{
  std::vector<std::uint32_t> indices(surface.triangles().size());
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

double signed_volume(const Surface& surface)
{
  double volume = 0;
  for (const Triangle& t : surface.triangles()) {
    const auto& p = surface.positions();
    volume += dot(p[std::size_t(t[0])], cross(p[std::size_t(t[1])], p[std::size_t(t[2])])) / 6;
  }
  return volume;
}

std::size_t cell_count(const CellBox& box)
{
  return std::size_t(box.size[0]) * std::size_t(box.size[1]) * std::size_t(box.size[2]);
}

std::vector<float> convert(const Surface& surface, const VoxelGrid& grid, const CellBox& box,
                           const float* carry = nullptr)
{
  std::vector<float> cells(cell_count(box));
  scan_convert(surface, grid, box, all_triangles(surface), carry, cells.data(), std::size_t(box.size[2]));
  return cells;
}

/// A grid of about n cells across the surface, with margin.
CellBox box_around(const Surface& surface, VoxelGrid& grid, int n)
{
  Vec3 low{1e9, 1e9, 1e9}, high = -low;
  for (const Vec3& p : surface.positions()) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  grid = {low - Vec3{0.013, 0.027, 0.041}, surface.diagonal() / n};
  const Vec3 cells = grid.to_cells(high);
  return {{0, 0, 0}, {int(cells.x) + 2, int(cells.y) + 2, int(cells.z) + 2}};
}

TEST(ScanConversion, KeepsTheSignedVolume)
{
  for (const TriangleMesh& mesh : {rotated(icosphere(3), normalized({1, 2, 3}), 0.4), torus(1, 0.4, 60, 30),
                                   rotated(box(1, 0.7, 0.4, 0.2), normalized({3, 1, 1}), 1.1)})
    for (const int n : {5, 40, 90}) {
      const Surface surface(mesh);
      VoxelGrid grid;
      const CellBox region = box_around(surface, grid, n);
      const std::vector<float> cells = convert(surface, grid, region);
      const double volume = std::accumulate(cells.begin(), cells.end(), 0.0) * grid.step * grid.step * grid.step;
      EXPECT_NEAR(volume / signed_volume(surface), 1, 2e-6);
    }
}

TEST(ScanConversion, AxisAlignedBoxCoversExactParts)
{
  const Surface surface(box(1, 1, 1, 1));
  const double edge = surface.diagonal() / std::sqrt(3.0);
  const VoxelGrid grid{Vec3{-0.75, -0.75, -0.75} * edge, edge / 4};  // the faces halve cells 1 + ½·… : at 1 and 5 cells
  const std::vector<float> cells =
      convert(surface, {grid.origin - Vec3{0.5, 0.25, 0.75} * grid.step, grid.step}, {{0, 0, 0}, {8, 8, 8}});
  const auto at = [&](int i, int j, int k) { return cells[std::size_t((i * 8 + j) * 8 + k)]; };
  EXPECT_NEAR(at(1, 3, 3), 0.5, 1e-6);
  EXPECT_NEAR(at(3, 1, 3), 0.75, 1e-6);
  EXPECT_NEAR(at(3, 3, 1), 0.25, 1e-6);
  EXPECT_NEAR(at(1, 1, 1), 0.5 * 0.75 * 0.25, 1e-6);
  EXPECT_NEAR(at(3, 3, 3), 1, 1e-6);
  EXPECT_NEAR(at(0, 3, 3), 0, 1e-6);
  EXPECT_NEAR(at(3, 3, 0), 0, 1e-6);
}

TEST(ScanConversion, RandomTetrahedraAgreeWithSampling)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int trial = 0; trial < 5; ++trial) {
    TriangleMesh mesh;
    for (int i = 0; i < 4; ++i) mesh.positions.push_back({coordinate(random), coordinate(random), coordinate(random)});
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    const Surface surface(mesh);
    VoxelGrid grid;
    const CellBox region = box_around(surface, grid, 5);
    const std::vector<float> cells = convert(surface, grid, region);
    constexpr int fine = 24;
    for (int i = 0; i < region.size[0]; ++i)
      for (int j = 0; j < region.size[1]; ++j)
        for (int k = 0; k < region.size[2]; ++k) {
          int inside = 0;
          for (int s = 0; s < fine * fine * fine; ++s) {
            const Vec3 u{i + (s % fine + 0.5) / fine, j + (s / fine % fine + 0.5) / fine,
                         k + (s / fine / fine + 0.5) / fine};
            const Vec3 x = grid.origin + u * grid.step;
            bool within = true;
            for (const Triangle& t : surface.triangles()) {
              const Vec3 &a = surface.positions()[std::size_t(t[0])], &b = surface.positions()[std::size_t(t[1])],
                         &c = surface.positions()[std::size_t(t[2])];
              within = within && dot(x - a, cross(b - a, c - a)) < 0;
            }
            inside += within;
          }
          const std::size_t cell = std::size_t((i * region.size[1] + j) * region.size[2] + k);
          ASSERT_NEAR(cells[cell], double(inside) / (fine * fine * fine), 0.02);
        }
  }
}

TEST(ScanConversion, TileWithCarryIsThatPartOfTheWholeGrid)
{
  const Surface surface(rotated(torus(1, 0.4, 40, 20), normalized({1, 1, 0}), 0.8));
  VoxelGrid grid;
  const CellBox whole = box_around(surface, grid, 60);
  const std::vector<float> expected = convert(surface, grid, whole);
  const CellBox tile{{7, 9, 0}, {20, 17, 11}};
  const std::vector<std::int64_t> tops{11, 20, 29};
  const std::size_t plane = 20 * 17;
  std::vector<float> carries(plane * tops.size());
  carry_planes(surface, grid, tile, all_triangles(surface), tops, carries.data());
  for (std::size_t t = 0; t < tops.size(); ++t) {
    CellBox part = tile;
    part.begin[2] = tops[t] - part.size[2];
    const std::vector<float> cells = convert(surface, grid, part, carries.data() + t * plane);
    for (int i = 0; i < part.size[0]; ++i)
      for (int j = 0; j < part.size[1]; ++j)
        for (int k = 0; k < part.size[2]; ++k)
          ASSERT_NEAR(cells[std::size_t((i * part.size[1] + j) * part.size[2] + k)],
                      expected[std::size_t(((i + 7) * whole.size[1] + j + 9) * whole.size[2] + k + int(part.begin[2]))],
                      2e-6);
  }
}

}  // namespace
