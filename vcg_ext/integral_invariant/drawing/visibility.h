// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: what of a line a viewer sees.
#pragma once

#include <cstdint>
#include <vector>

#include "integral_invariant/drawing/surface_line.h"
#include "integral_invariant/drawing/view.h"
#include "integral_invariant/mesh.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// The triangles of a surface as a viewer sees them, in the cells of a grid over the picture. Memory: 4 bytes for each
/// cell that a triangle touches (about three a triangle), 24 bytes a vertex.
class DepthGrid {
 public:
  /// Lengths are average edges. Cost: O(n + m). \throw Cancelled
  DepthGrid(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles, const View& view,
            Execution& execution);

  /// Whether a triangle lies over `point` (as View::project() gives it) by more than `clearance`.
  bool is_covered(const Vec3& point, double clearance) const;

 private:
  std::size_t cell_of(double x, double y) const;

  std::vector<Vec3> projected_;
  const std::vector<Triangle>& triangles_;
  double left_ = 0, bottom_ = 0;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> start_, members_;
};

/// For each point of the line whether it is seen. A point is tried a little above the surface, so that the triangles
/// around it do not hide it; at a contour this lies just outside the fold that the surface makes there. A contour on
/// which the radial curvature is negative is hidden by the surface itself. Changes that last less than
/// `shortest_change` are undone.
std::vector<char> visible_points(const SurfaceLine& line, const DepthGrid& grid, const View& view,
                                 double shortest_change);

}  // namespace integral_invariant
