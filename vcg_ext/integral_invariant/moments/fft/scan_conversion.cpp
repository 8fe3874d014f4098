// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1, FFT engine: exact covered fractions of cells. A triangle seen along z covers, with the sign of its
// orientation, the part of each column below it; cut along the planes of the grid it falls into pieces that each lie in
// one cell, and a piece of area a (seen along z) at mean height t above the floor of its cell adds a·t to that cell and
// a to all cells below. Differences along z are stored, and one running sum from the top makes them fractions.
#include "integral_invariant/moments/fft/scan_conversion.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

namespace {

/// x, y, z; unlike Vec3 left uninitialised, since polygons are made and dropped by the million.
using Point = double[3];

/// A convex polygon; a triangle cut by six planes has at most nine corners.
struct Polygon {
  int size = 0;
  Point corner[12];
  void add(const Point& v)
  {
    for (int a = 0; a < 3; ++a) corner[size][a] = v[a];
    ++size;
  }
};

struct Range {
  double low, high;
};

template <int axis>
Range range_along(const Polygon& polygon)
{
  Range range{polygon.corner[0][axis], polygon.corner[0][axis]};
  for (int i = 1; i < polygon.size; ++i) {
    range.low = std::min(range.low, polygon.corner[i][axis]);
    range.high = std::max(range.high, polygon.corner[i][axis]);
  }
  return range;
}

/// Adds to both the point where the edge from a (below the plane) to b (above) meets it. Always taken from below to
/// above, so that the two triangles at an edge are cut at the same point to the last bit and no area is lost between
/// them.
template <int axis>
void add_cut(const Point& a, const Point& b, double plane, Polygon& below, Polygon& above)
{
  const double t = (plane - a[axis]) / (b[axis] - a[axis]);
  Point point;
  for (int i = 0; i < 3; ++i) point[i] = i == axis ? plane : a[i] + (b[i] - a[i]) * t;
  below.add(point);
  above.add(point);
}

template <int axis>
void split(const Polygon& polygon, double plane, Polygon& below, Polygon& above)
{
  below.size = above.size = 0;
  int previous = polygon.size - 1;
  for (int i = 0; i < polygon.size; previous = i++) {
    const Point &last = polygon.corner[previous], &current = polygon.corner[i];
    const double from = last[axis] - plane, to = current[axis] - plane;
    if (from < 0 && to > 0) add_cut<axis>(last, current, plane, below, above);
    if (from > 0 && to < 0) add_cut<axis>(current, last, plane, below, above);
    if (to <= 0) below.add(current);
    if (to >= 0) above.add(current);
  }
}

/// Calls `visit(index, part)` for the parts of the polygon in the slabs [index, index + 1] along `axis`, 0 ≤ index <
/// count.
template <int axis, class Visitor>
void for_each_slab(const Polygon& polygon, int count, const Visitor& visit)
{
  const Range range = range_along<axis>(polygon);
  if (range.high <= 0 || range.low >= count) return;
  const int first = range.low > 0 ? int(range.low) : 0;
  if (range.low >= 0 && range.high <= first + 1) return visit(first, polygon);
  Polygon below, rests[2];
  const Polygon* rest = &polygon;
  int next = 0;
  const auto cut_at = [&](double plane) {
    split<axis>(*rest, plane, below, rests[next]);
    rest = &rests[next];
    next = 1 - next;
  };
  if (range.low < 0) cut_at(0);
  for (int index = first; index < count && rest->size >= 3; ++index) {
    if (range.high <= index + 1) return visit(index, *rest);
    cut_at(index + 1);
    if (below.size >= 3) visit(index, below);
  }
}

/// Signed area seen along z and integral of z over it.
struct ProjectedIntegral {
  double area = 0, height = 0;
};

ProjectedIntegral project(const Polygon& polygon)
{
  ProjectedIntegral sum;
  const Point& a = polygon.corner[0];
  for (int i = 1; i + 1 < polygon.size; ++i) {
    const Point &b = polygon.corner[i], &c = polygon.corner[i + 1];
    const double area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    sum.area += area;
    sum.height += area * (a[2] + b[2] + c[2]) * (1.0 / 3);
  }
  return sum;
}

/// The triangle in cells from the corner of the box.
Polygon triangle_in_box(const Surface& surface, std::uint32_t index, const VoxelGrid& grid, const CellBox& box)
{
  const Vec3 corner{double(box.begin[0]), double(box.begin[1]), double(box.begin[2])};
  Polygon polygon;
  for (const std::int32_t vertex : surface.triangles()[index]) {
    const Vec3 cell = grid.to_cells(surface.positions()[std::size_t(vertex)]) - corner;
    polygon.add({cell.x, cell.y, cell.z});
  }
  return polygon;
}

bool misses(const Range& range, double count) { return range.high <= 0 || range.low >= count; }

/// From differences to fractions, from the top down, for `count` neighbouring columns at once: the running sums are
/// independent, so the processor need not wait for one before it adds to the next.
template <std::size_t count>
void sum_down(int height, const float* carry, float* cells, std::size_t row_stride)
{
  double sums[count];
  for (std::size_t c = 0; c < count; ++c) sums[c] = carry ? double(carry[c]) : 0.0;
  for (std::size_t k = std::size_t(height); k-- > 0;)
    for (std::size_t c = 0; c < count; ++c) {
      float& cell = cells[c * row_stride + k];
      sums[c] += double(cell);
      cell = float(std::clamp(sums[c], 0.0, 1.0));
    }
}

void sum_columns(const CellBox& box, const float* carry, float* cells, std::size_t row_stride)
{
  constexpr std::size_t group = 8;
  const std::size_t columns = std::size_t(box.size[0]) * std::size_t(box.size[1]);
  std::size_t column = 0;
  for (; column + group <= columns; column += group)
    sum_down<group>(box.size[2], carry ? carry + column : nullptr, cells + column * row_stride, row_stride);
  for (; column < columns; ++column)
    sum_down<1>(box.size[2], carry ? carry + column : nullptr, cells + column * row_stride, row_stride);
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
    for_each_slab<0>(polygon, box.size[0], [&](int i, const Polygon& slab) {
      for_each_slab<1>(slab, box.size[1], [&](int j, const Polygon& part) {
        plane[std::size_t(i) * std::size_t(box.size[1]) + std::size_t(j)] += float(project(part).area);
      });
    });
  };
  for (const std::uint32_t index : triangles) {
    Polygon rest = triangle_in_box(surface, index, grid, base), below, above;
    if (misses(range_along<0>(rest), box.size[0]) || misses(range_along<1>(rest), box.size[1])) continue;
    const Range height = range_along<2>(rest);
    const auto above_of = std::upper_bound(tops.begin(), tops.end(), height.low,
                                           [](double z, std::int64_t top) { return z < double(top); });
    std::size_t t = std::size_t(above_of - tops.begin());  // the piece in hand lies above the tops before t
    for (; t < tops.size() && double(tops[t]) < height.high; ++t) {
      split<2>(rest, double(tops[t]), below, above);
      if (t > 0 && below.size >= 3) add_area(below, planes + (t - 1) * plane_size);
      rest = above;
    }
    if (t > 0 && rest.size >= 3) add_area(rest, planes + (t - 1) * plane_size);
  }
  for (std::size_t t = tops.size(); t-- > 1;)
    for (std::size_t i = 0; i < plane_size; ++i) planes[(t - 1) * plane_size + i] += planes[t * plane_size + i];
}

void scan_convert(const Surface& surface, const VoxelGrid& grid, const CellBox& box,
                  const std::vector<std::uint32_t>& triangles, const float* carry, float* cells, std::size_t row_stride)
{
  const std::size_t columns = std::size_t(box.size[0]) * std::size_t(box.size[1]);
  std::fill(cells, cells + columns * row_stride, 0.0f);
  for (const std::uint32_t index : triangles) {
    const Polygon triangle = triangle_in_box(surface, index, grid, box);
    if (misses(range_along<0>(triangle), box.size[0]) || misses(range_along<1>(triangle), box.size[1]) ||
        misses(range_along<2>(triangle), box.size[2]))
      continue;
    for_each_slab<0>(triangle, box.size[0], [&](int i, const Polygon& slab) {
      for_each_slab<1>(slab, box.size[1], [&](int j, const Polygon& column) {
        float* row = cells + (std::size_t(i) * std::size_t(box.size[1]) + std::size_t(j)) * row_stride;
        for_each_slab<2>(column, box.size[2], [&](int k, const Polygon& piece) {
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
