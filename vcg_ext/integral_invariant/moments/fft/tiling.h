// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1, FFT engine: which boxes of the grid are transformed for one radius. In: a surface, a radius. Out: tiles of
// one size that hold all vertices, each with its vertices and triangles (overlap-save: neighbouring boxes overlap by
// the radius). Cost O(n + m) per tile size tried. Depends on the surface and the parameters only, never on the threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "integral_invariant/moments/fft/scan_conversion.h"

namespace integral_invariant {

/// Lists of indices, one per row: indices[start[row]] up to indices[start[row + 1]].
struct IndexLists {
  std::vector<std::size_t> start;
  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> row(std::size_t r) const
  {
    return {indices.begin() + std::ptrdiff_t(start[r]), indices.begin() + std::ptrdiff_t(start[r + 1])};
  }
};

/// How the grid of one radius is cut up.
struct TileShape {
  std::array<int, 3> size{};            ///< of the transform, in cells
  std::array<int, 3> inner{};           ///< cells whose vertices the tile serves
  std::array<int, 3> margin{};          ///< cells of a tile below its inner ones
  std::array<std::int64_t, 3> count{};  ///< tiles along each axis to cover the bounding box
  double cost = 0;                      ///< of all tiles that hold vertices, in arbitrary units
};

using TileIndex = std::array<std::int64_t, 3>;

/// The tiles that hold vertices, in lexicographic order; those that share x and y are a stack.
struct Tiling {
  VoxelGrid grid;
  double radius_cells = 0;
  TileShape shape;
  std::vector<TileIndex> tiles;
  std::vector<std::size_t> stack_start;  ///< first tile of each stack, and the number of tiles
  IndexLists tile_vertices;

  CellBox box(std::size_t tile) const;
  std::size_t stack_count() const { return stack_start.size() - 1; }
};

/// Bytes that one worker needs for tiles of this shape, and that all workers share.
std::size_t worker_bytes(const TileShape& shape);

/// The cheapest tiles whose worker_bytes() do not exceed `limit`. `cells_per_radius` is radius over grid step.
/// \throw Cancelled, or MemoryError where the smallest exceed it, or where the grid has more than 2^30 cells along an
/// axis
Tiling make_tiling(const Surface& surface, double radius, double cells_per_radius, std::size_t limit,
                   Execution& execution);

/// Triangles that touch each tile's box, and those that touch each stack's columns.
IndexLists tile_triangles(const Surface& surface, const Tiling& layout, Execution& execution);
IndexLists stack_triangles(const Surface& surface, const Tiling& layout, Execution& execution);

}  // namespace integral_invariant
