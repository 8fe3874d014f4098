// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: coordinates that were rounded, and surfaces that were taken out of a grid of voxels.
#pragma once

#include <array>

#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/support/axes.h"

namespace integral_invariant {

/// What the coordinates tell about where a mesh comes from.
struct CoordinateLattice {
  /// Along each axis, the steps that coordinates were rounded to, or the width of the voxels of a binary mask; 0: not
  /// rounded.
  std::array<double, 3> steps{};
  /// Each vertex lies on an edge of a grid, as marching cubes leave it: two of its three coordinates are the grid's.
  bool is_from_grid = false;
  Axes axes;  ///< that normals are along, seen from the lattice's

  bool is_rounded() const { return steps[0] > 0 || steps[1] > 0 || steps[2] > 0; }
  /// Variance of the rounding along a normal: that of a uniform error as wide as the step along each axis.
  double variance_along(const Vec3& normal) const;
};

/// Coordinates that many vertices share lie on a lattice where they are whole steps apart. Vertices with all three on
/// one were rounded (in a binary mask they lie half way between two voxels along one axis, so that a voxel is two steps
/// wide); where the heights alone are, these. A regular grid below free heights is sampling and no noise, the columns
/// of a scanner are, and so is a box whose sides were sampled on a lattice. Cost O(m), and O(n log n) of at most 20,000
/// vertices.
CoordinateLattice find_coordinate_lattice(const Surface& surface);

}  // namespace integral_invariant
