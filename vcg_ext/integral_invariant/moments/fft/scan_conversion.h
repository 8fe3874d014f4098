// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1, FFT engine: the solid on a voxel grid. In: the triangles of a closed surface. Out: the covered fraction of
// each cell of a box, exact for the polyhedron (χ_D averaged over the cell), single precision.
// Cost: O(triangles + cells that the surface crosses + cells of the box).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "integral_invariant/mesh/surface.h"

namespace integral_invariant {

/// A grid of cubic cells over all space; cell (0,0,0) has its lowest corner at `origin`. Normalised unit.
struct VoxelGrid {
  Vec3 origin;
  double step = 1;
  /// Position in cells: the centre of cell (i,j,k) is at (i + ½, j + ½, k + ½).
  Vec3 to_cells(const Vec3& p) const { return (p - origin) * (1 / step); }
};

/// The cells begin ≤ (i,j,k) < begin + size.
struct CellBox {
  std::array<std::int64_t, 3> begin{};
  std::array<int, 3> size{};
};

/// For each of the heights `tops` (in cells, increasing) the area of each column of `box` that the solid covers just
/// above that height: what scan_convert() cannot see because it lies above its box. `planes` takes tops.size() planes
/// of box.size[0] × box.size[1] floats; box's z is not used. `triangles` must name every triangle that touches a column
/// of the box anywhere above the lowest top.
void carry_planes(const Surface& surface, const VoxelGrid& grid, const CellBox& box,
                  const std::vector<std::uint32_t>& triangles, const std::vector<std::int64_t>& tops, float* planes);

/// Covered fraction of each cell of `box`: the winding number of the surface averaged over the cell, clamped to [0, 1].
/// `cells` has rows along z of `row_stride` >= box.size[2] floats, y within x; what is past a row's end becomes 0.
/// `triangles` must name every triangle that touches the box; `carry` is the plane of carry_planes() at the box's top
/// (null where nothing lies above).
void scan_convert(const Surface& surface, const VoxelGrid& grid, const CellBox& box,
                  const std::vector<std::uint32_t>& triangles, const float* carry, float* cells,
                  std::size_t row_stride);

}  // namespace integral_invariant
