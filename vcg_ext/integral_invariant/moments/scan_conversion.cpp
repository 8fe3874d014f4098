// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1, FFT engine: exact covered fractions of cells. A triangle seen along z covers, with the sign of its
// orientation, the part of each column below it; cut along the planes of the grid it falls into pieces that each lie in
// one cell, and a piece of area a (seen along z) at mean height t above the floor of its cell adds a·t to that cell and a
// to all cells below. Differences along z are stored, and one running sum from the top makes them fractions.
#include "integral_invariant/moments/scan_conversion.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

namespace {

/// A convex polygon; a triangle cut by six planes has at most nine corners.
struct Polygon {
  int size = 0;
  std::array<Vec3, 12> corner;
  void add(const Vec3& v) { corner[std::size_t(size++)] = v; }
};

struct Range {
  double low, high;
};

Range range_along(const Polygon& polygon, double Vec3::*axis)
{
  Range range{polygon.corner[0].*axis, polygon.corner[0].*axis};
  for (int i = 1; i < polygon.size; ++i) {
    const double value = polygon.corner[std::size_t(i)].*axis;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  return range;
}

/// Where the edge from a (below the plane) to b (above) meets it. Always taken from below to above, so that the two
/// triangles at an edge are cut at the same point to the last bit and no area is lost between them.
Vec3 cut(const Vec3& a, const Vec3& b, double Vec3::*axis, double plane)
{
  Vec3 point = a + (b - a) * ((plane - a.*axis) / (b.*axis - a.*axis));
  point.*axis = plane;
  return point;
}

void split(const Polygon& polygon, double Vec3::*axis, double plane, Polygon& below, Polygon& above)
{
  below.size = above.size = 0;
  const Vec3* previous = &polygon.corner[std::size_t(polygon.size - 1)];
  for (int i = 0; i < polygon.size; ++i) {
    const Vec3* current = &polygon.corner[std::size_t(i)];
    const double from = previous->*axis - plane, to = current->*axis - plane;
    if (from < 0 && to > 0) {
      const Vec3 point = cut(*previous, *current, axis, plane);
      below.add(point);
      above.add(point);
    } else if (from > 0 && to < 0) {
      const Vec3 point = cut(*current, *previous, axis, plane);
      below.add(point);
      above.add(point);
    }
    if (to <= 0) below.add(*current);
    if (to >= 0) above.add(*current);
    previous = current;
  }
}

/// Calls `visit(index, part)` for the parts of the polygon in the slabs [index, index + 1] along `axis`, 0 ≤ index < count.
template <class Visitor>
void for_each_slab(Polygon polygon, double Vec3::*axis, int count, const Visitor& visit)
{
  const Range range = range_along(polygon, axis);
  if (range.high <= 0 || range.low >= count) return;
  Polygon below, above;
  if (range.low < 0) {
    split(polygon, axis, 0, below, above);
    polygon = above;
  }
  const int first = range.low > 0 ? int(range.low) : 0;
  for (int index = first; index < count && polygon.size >= 3; ++index) {
    if (range.high <= index + 1) {
      visit(index, polygon);
      return;
    }
    split(polygon, axis, index + 1, below, above);
    if (below.size >= 3) visit(index, below);
    polygon = above;
  }
}

/// Signed area seen along z and integral of z over it.
struct ProjectedIntegral {
  double area = 0, height = 0;
};

ProjectedIntegral project(const Polygon& polygon)
{
  ProjectedIntegral sum;
  const Vec3& a = polygon.corner[0];
  for (std::size_t i = 1; i + 1 < std::size_t(polygon.size); ++i) {
    const Vec3 &b = polygon.corner[i], &c = polygon.corner[i + 1];
    const double area = 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    sum.area += area;
    sum.height += area * (a.z + b.z + c.z) * (1.0 / 3);
  }
  return sum;
}

/// The triangle in cells from the corner of the box.
Polygon triangle_in_box(const Surface& surface, std::uint32_t index, const VoxelGrid& grid, const CellBox& box)
{
  const Vec3 corner{double(box.begin[0]), double(box.begin[1]), double(box.begin[2])};
  Polygon polygon;
  for (const std::int32_t vertex : surface.triangles()[index])
    polygon.add(grid.to_cells(surface.positions()[std::size_t(vertex)]) - corner);
  return polygon;
}

bool misses(const Range& range, double count) { return range.high <= 0 || range.low >= count; }

/// From differences to fractions, from the top of each column down.
void sum_columns(const CellBox& box, const float* carry, float* cells, std::size_t row_stride)
{
  const std::size_t columns = std::size_t(box.size[0]) * std::size_t(box.size[1]);
  for (std::size_t column = 0; column < columns; ++column) {
    float* row = cells + column * row_stride;
    double sum = carry ? double(carry[column]) : 0.0;
    for (int k = box.size[2] - 1; k >= 0; --k) {
      sum += double(row[k]);
      row[k] = float(std::clamp(sum, 0.0, 1.0));
    }
  }
}

}  // namespace

void carry_planes(const Surface& surface, const VoxelGrid& grid, const CellBox& box,
                  const std::vector<std::uint32_t>& triangles, const std::vector<std::int64_t>& tops, float* planes)
{
  const std::size_t plane_size = std::size_t(box.size[0]) * std::size_t(box.size[1]);
  std::fill(planes, planes + plane_size * tops.size(), 0.0f);
  CellBox base = box;
  base.begin[2] = 0;
  const auto add_area = [&](const Polygon& polygon, float* plane) {
    for_each_slab(polygon, &Vec3::x, box.size[0], [&](int i, const Polygon& slab) {
      for_each_slab(slab, &Vec3::y, box.size[1], [&](int j, const Polygon& part) {
        plane[std::size_t(i) * std::size_t(box.size[1]) + std::size_t(j)] += float(project(part).area);
      });
    });
  };
  for (const std::uint32_t index : triangles) {
    Polygon rest = triangle_in_box(surface, index, grid, base), below, above;
    if (misses(range_along(rest, &Vec3::x), box.size[0]) || misses(range_along(rest, &Vec3::y), box.size[1])) continue;
    const Range height = range_along(rest, &Vec3::z);
    const auto above_of = std::upper_bound(tops.begin(), tops.end(), height.low,
                                           [](double z, std::int64_t top) { return z < double(top); });
    std::size_t t = std::size_t(above_of - tops.begin());  // the piece in hand lies above the tops before t
    for (; t < tops.size() && double(tops[t]) < height.high; ++t) {
      split(rest, &Vec3::z, double(tops[t]), below, above);
      if (t > 0 && below.size >= 3) add_area(below, planes + (t - 1) * plane_size);
      rest = above;
    }
    if (t > 0 && rest.size >= 3) add_area(rest, planes + (t - 1) * plane_size);
  }
  for (std::size_t t = tops.size(); t-- > 1;)
    for (std::size_t i = 0; i < plane_size; ++i) planes[(t - 1) * plane_size + i] += planes[t * plane_size + i];
}

void scan_convert(const Surface& surface, const VoxelGrid& grid, const CellBox& box,
                  const std::vector<std::uint32_t>& triangles, const float* carry, float* cells,
                  std::size_t row_stride)
{
  const std::size_t columns = std::size_t(box.size[0]) * std::size_t(box.size[1]);
  std::fill(cells, cells + columns * row_stride, 0.0f);
  for (const std::uint32_t index : triangles) {
    const Polygon triangle = triangle_in_box(surface, index, grid, box);
    if (misses(range_along(triangle, &Vec3::x), box.size[0]) ||
        misses(range_along(triangle, &Vec3::y), box.size[1]) || misses(range_along(triangle, &Vec3::z), box.size[2]))
      continue;
    for_each_slab(triangle, &Vec3::x, box.size[0], [&](int i, const Polygon& slab) {
      for_each_slab(slab, &Vec3::y, box.size[1], [&](int j, const Polygon& column) {
        float* row = cells + (std::size_t(i) * std::size_t(box.size[1]) + std::size_t(j)) * row_stride;
        for_each_slab(column, &Vec3::z, box.size[2], [&](int k, const Polygon& piece) {
          const ProjectedIntegral sum = project(piece);
          const double covered = sum.height - sum.area * k;
          row[k] += float(covered);
          if (k > 0) row[k - 1] += float(sum.area - covered);
        });
      });
    });
  }
  sum_columns(box, carry, cells, row_stride);
}

}  // namespace integral_invariant
