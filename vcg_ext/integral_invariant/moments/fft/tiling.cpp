// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/moments/fft/tiling.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/error.h"
#include "integral_invariant/moments/fft/ball_spectrum.h"
#include "integral_invariant/moments/fft/fftw_plan.h"
#include "integral_invariant/moments/fft/spline.h"
#include "integral_invariant/support/memory.h"

namespace integral_invariant {

namespace {

/// Cells that the corrected kernel reaches beyond the ball: half a cell, the spline's two, and its ringing.
constexpr int kernel_margin = 4;
constexpr double largest_grid = 1 << 30;
/// Edges of tiles that are tried. FFTW's estimated plans are fastest for powers of two (see slowdown()).
constexpr int tile_edges[] = {16, 32, 64, 128, 256, 512};
/// Vertices looked at to estimate how many tiles of a shape are needed, where that gives each tile this many of them.
constexpr std::size_t sampled_vertices = 50000, samples_per_tile = 20;

constexpr const char* coarser_advice =
    "Lower fft_cells_per_radius, raise r_min, raise the memory limit, or use the surface integral engine, which needs "
    "no grid.";

bool is_smooth(int n)
{
  for (const int p : {2, 3, 5, 7})
    while (n % p == 0) n /= p;
  return n == 1;
}

/// Time per sample along one axis relative to a power of two, as measured with estimated plans of 32³ to 192³.
double slowdown(int n) { return (n & (n - 1)) == 0 ? 1.0 : 1.3; }

/// The quickest size of at least n.
int fast_size(int n)
{
  int best = 1;
  while (best < n) best *= 2;
  for (int size = n; size < best; ++size)
    if (is_smooth(size) && size * slowdown(size) < best * slowdown(best)) return size;
  return best;
}

double transform_cost(const std::array<int, 3>& size)
{
  double samples = 1, cost = 1;
  for (const int n : size) {
    samples *= n;
    cost *= n * slowdown(n);
  }
  return cost * std::log2(samples) * (samples > 1e6 ? 1.5 : 1.0);  // beyond the cache of a core
}

using Extent = std::array<std::int64_t, 3>;

/// The shape with tiles of about `edge` cells; an axis that fits into one tile needs its margin of zeros only once,
/// since there the solid's outside wraps onto itself. Empty where the edge is too small.
TileShape shape_with_edge(const Extent& extent, int edge, int halo)
{
  TileShape shape;
  for (std::size_t a = 0; a < 3; ++a) {
    if (extent[a] + halo <= edge) {
      shape.size[a] = fast_size(int(extent[a]) + halo);
      shape.inner[a] = int(extent[a]);
      shape.margin[a] = spline_support;
    } else {
      if (edge - 2 * halo < 4) return {};
      shape.size[a] = edge;
      shape.inner[a] = edge - 2 * halo;
      shape.margin[a] = halo;
    }
    shape.count[a] = (extent[a] + shape.inner[a] - 1) / shape.inner[a];
  }
  return shape;
}

TileIndex tile_of(const Vec3& position, const VoxelGrid& grid, const TileShape& shape)
{
  const Vec3 cell = grid.to_cells(position);
  const double u[3] = {cell.x, cell.y, cell.z};
  TileIndex index;
  for (std::size_t a = 0; a < 3; ++a)
    index[a] = std::clamp<std::int64_t>(std::int64_t(std::floor(u[a])) / shape.inner[a], 0, shape.count[a] - 1);
  return index;
}

std::vector<TileIndex> occupied_tiles(const Surface& surface, const VoxelGrid& grid, const TileShape& shape,
                                      std::size_t stride, Execution& execution)
{
  std::vector<TileIndex> tiles;
  for_each_in_order((surface.vertex_count() + stride - 1) / stride, execution, [&](std::size_t i) {
    const std::size_t v = i * stride;
    if (!surface.is_referenced(v)) return;
    const TileIndex index = tile_of(surface.positions()[v], grid, shape);
    if (tiles.empty() || index != tiles.back()) tiles.push_back(index);
  });
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
  return tiles;
}

/// Number of occupied tiles, from a sample of the vertices where tiles are large enough for that.
std::size_t estimated_tiles(const Surface& surface, const VoxelGrid& grid, const TileShape& shape, Execution& execution)
{
  const std::size_t stride = std::max<std::size_t>(1, surface.vertex_count() / sampled_vertices);
  const std::size_t found = occupied_tiles(surface, grid, shape, stride, execution).size();
  if (stride == 1 || found * samples_per_tile < surface.vertex_count() / stride) return found;
  return occupied_tiles(surface, grid, shape, 1, execution).size();
}

Box bounds_of(const Surface& surface, Execution& execution)
{
  Box bounds;
  for_each_in_order(surface.vertex_count(), execution, [&](std::size_t v) {
    if (surface.is_referenced(v)) bounds.add(surface.positions()[v]);
  });
  return bounds;
}

Extent extent_in_cells(const Box& bounds, const VoxelGrid& grid)
{
  const Vec3 cells = grid.to_cells(bounds.high);
  Extent extent;
  const double length[3] = {cells.x, cells.y, cells.z};
  for (std::size_t a = 0; a < 3; ++a) {
    if (!(length[a] < largest_grid))
      throw MemoryError("The voxel grid would have " + std::to_string(std::llround(length[a] / 1e6)) +
                        " million cells along one axis. " + coarser_advice);
    extent[a] = std::int64_t(length[a]) + 1;
  }
  return extent;
}

TileShape cheapest_shape(const Surface& surface, const VoxelGrid& grid, const Extent& extent, int halo,
                         std::size_t limit, Execution& execution)
{
  std::size_t least = ~std::size_t(0);
  TileShape best;
  for (const int edge : tile_edges) {
    TileShape shape = shape_with_edge(extent, edge, halo);
    if (shape.size[0] == 0) continue;
    least = std::min(least, worker_bytes(shape));
    if (worker_bytes(shape) > limit) continue;
    shape.cost = double(estimated_tiles(surface, grid, shape, execution)) * transform_cost(shape.size);
    if (best.cost == 0 || shape.cost < best.cost) best = shape;
  }
  if (best.cost == 0)
    throw MemoryError("The smallest piece of the voxel grid that can be transformed (of " + std::to_string(extent[0]) +
                      " x " + std::to_string(extent[1]) + " x " + std::to_string(extent[2]) + " cells in all) needs " +
                      readable_bytes(double(least)) + ", more than half of the memory limit, " +
                      readable_bytes(double(limit)) + ". " + coarser_advice);
  return best;
}

/// Calls visit(row) for the rows that a triangle touches, rows being tiles or stacks in lexicographic order. `axes` is
/// 3 for tiles, 2 for stacks.
template <class Visitor>
void for_each_row(const Surface& surface, const Tiling& layout, const std::vector<TileIndex>& rows, std::size_t axes,
                  const Triangle& triangle, const Visitor& visit)
{
  TileIndex first{}, last{};
  double candidates = 1;
  for (std::size_t a = 0; a < axes; ++a) {
    constexpr double Vec3::*axis[3] = {&Vec3::x, &Vec3::y, &Vec3::z};
    double low = 1e300, high = -1e300;
    for (const std::int32_t vertex : triangle) {
      const double u = layout.grid.to_cells(surface.positions()[std::size_t(vertex)]).*axis[a];
      low = std::min(low, u);
      high = std::max(high, u);
    }
    const TileShape& shape = layout.shape;
    const double inner = shape.inner[a], margin = shape.margin[a];
    first[a] = std::max<std::int64_t>(0, std::int64_t(std::floor((low + margin - shape.size[a]) / inner)));
    last[a] = std::min<std::int64_t>(shape.count[a] - 1, std::int64_t(std::floor((high + margin) / inner)));
    candidates *= double(last[a] - first[a] + 1);
  }
  const auto within = [&](const TileIndex& t) {
    for (std::size_t a = 0; a < axes; ++a)
      if (t[a] < first[a] || t[a] > last[a]) return false;
    return true;
  };
  if (candidates > double(rows.size())) {
    for (std::size_t row = 0; row < rows.size(); ++row)
      if (within(rows[row])) visit(row);
    return;
  }
  for (std::int64_t x = first[0]; x <= last[0]; ++x)
    for (std::int64_t y = first[1]; y <= last[1]; ++y) {
      auto row = std::lower_bound(rows.begin(), rows.end(), TileIndex{x, y, first[2]});
      for (; row != rows.end() && (*row)[0] == x && (*row)[1] == y && (*row)[2] <= last[2]; ++row)
        visit(std::size_t(row - rows.begin()));
    }
}

IndexLists list_triangles(const Surface& surface, const Tiling& layout, const std::vector<TileIndex>& rows,
                          std::size_t axes, Execution& execution)
{
  IndexLists lists;
  lists.start.assign(rows.size() + 1, 0);
  const std::vector<Triangle>& triangles = surface.triangles();
  for_each_in_order(triangles.size(), execution, [&](std::size_t t) {
    for_each_row(surface, layout, rows, axes, triangles[t], [&](std::size_t row) { ++lists.start[row + 1]; });
  });
  for (std::size_t row = 0; row < rows.size(); ++row) lists.start[row + 1] += lists.start[row];
  resize_in_steps(lists.indices, lists.start.back(), execution);
  std::vector<std::size_t> next(lists.start.begin(), lists.start.end() - 1);
  for_each_in_order(triangles.size(), execution, [&](std::size_t t) {
    for_each_row(surface, layout, rows, axes, triangles[t],
                 [&](std::size_t row) { lists.indices[next[row]++] = std::uint32_t(t); });
  });
  return lists;
}

IndexLists list_vertices(const Surface& surface, const Tiling& layout, Execution& execution)
{
  std::vector<std::uint32_t> tile(surface.vertex_count());
  IndexLists lists;
  lists.start.assign(layout.tiles.size() + 1, 0);
  for_each_in_order(tile.size(), execution, [&](std::size_t v) {
    if (!surface.is_referenced(v)) return;
    const TileIndex index = tile_of(surface.positions()[v], layout.grid, layout.shape);
    tile[v] = std::uint32_t(std::lower_bound(layout.tiles.begin(), layout.tiles.end(), index) - layout.tiles.begin());
    ++lists.start[tile[v] + 1];
  });
  for (std::size_t t = 0; t < layout.tiles.size(); ++t) lists.start[t + 1] += lists.start[t];
  lists.indices.resize(lists.start.back());
  std::vector<std::size_t> next(lists.start.begin(), lists.start.end() - 1);
  for_each_in_order(tile.size(), execution, [&](std::size_t v) {
    if (surface.is_referenced(v)) lists.indices[next[tile[v]]++] = std::uint32_t(v);
  });
  return lists;
}

}  // namespace

std::size_t worker_bytes(const TileShape& shape) { return 2 * FftBuffer::bytes(shape.size); }

CellBox Tiling::box(std::size_t tile) const
{
  CellBox box;
  for (std::size_t a = 0; a < 3; ++a) box.begin[a] = tiles[tile][a] * shape.inner[a] - shape.margin[a];
  box.size = shape.size;
  return box;
}

Tiling make_tiling(const Surface& surface, double radius, double cells_per_radius, std::size_t limit,
                   Execution& execution)
{
  // Cells grow with the inverse square of the radius, and under it a ball sees a single triangle.
  constexpr double smallest_radius = 0.1;
  if (radius < smallest_radius)
    throw ParameterError(
        "The smallest radius is under a tenth of the average edge length, which the voxel engine's grid cannot "
        "resolve at a bearable cost. Raise r_min (or radius), or use the surface integral engine.");
  Tiling layout;
  const Box bounds = bounds_of(surface, execution);
  layout.grid = {bounds.low, radius / cells_per_radius};
  layout.radius_cells = cells_per_radius;
  const Extent extent = extent_in_cells(bounds, layout.grid);
  const int halo = int(std::ceil(cells_per_radius)) + kernel_margin;
  layout.shape = cheapest_shape(surface, layout.grid, extent, halo, limit, execution);
  layout.tiles = occupied_tiles(surface, layout.grid, layout.shape, 1, execution);
  for (std::size_t t = 0; t < layout.tiles.size(); ++t)
    if (t == 0 || layout.tiles[t][0] != layout.tiles[t - 1][0] || layout.tiles[t][1] != layout.tiles[t - 1][1])
      layout.stack_start.push_back(t);
  layout.stack_start.push_back(layout.tiles.size());
  layout.tile_vertices = list_vertices(surface, layout, execution);
  return layout;
}

IndexLists tile_triangles(const Surface& surface, const Tiling& layout, Execution& execution)
{
  return list_triangles(surface, layout, layout.tiles, 3, execution);
}

IndexLists stack_triangles(const Surface& surface, const Tiling& layout, Execution& execution)
{
  std::vector<TileIndex> stacks;
  for (std::size_t s = 0; s < layout.stack_count(); ++s) {
    const TileIndex& tile = layout.tiles[layout.stack_start[s]];
    stacks.push_back({tile[0], tile[1], 0});
  }
  return list_triangles(surface, layout, stacks, 2, execution);
}

}  // namespace integral_invariant
