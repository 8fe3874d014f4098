// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: all lines of a surface, and what of them each view shows.
#pragma once

#include <vector>

#include "integral_invariant/drawing/field_derivative.h"
#include "integral_invariant/drawing/surface_line.h"
#include "integral_invariant/drawing/view.h"
#include "integral_invariant/drawing/zero_lines.h"
#include "integral_invariant/features/topology.h"

namespace integral_invariant {

enum class Axis { x = 0, y = 1, z = 2 };
enum class HiddenLines { dropped = 0, dashed = 1 };

struct LineDrawingParameters {
  bool contours = true, boundaries = true, creases = true, suggestive_contours = true;
  bool suggestive_highlights = false, apparent_ridges = false, ridges = false, valleys = false;
  bool demarcating_curves = false, hatching = false;
  int sections = 0;             ///< number of parallel planes, evenly spaced through the box
  Axis section_axis = Axis::x;  ///< orthogonal to them
  double significance = 3;      ///< z that a line has on average along its length
  double minimum_length = 0;    ///< L; 0: five average edge lengths
  double crease_angle = 30;     ///< degrees between triangles
  double hatching_spacing = 0;  ///< L; 0: four average edge lengths
  HiddenLines hidden = HiddenLines::dropped;
};

/// \throw ParameterError where a parameter is out of its range or nothing is asked for
void require_drawable(const LineDrawingParameters& parameters);

/// A line of one view: all of it is seen, or nothing.
struct ViewLine {
  SurfaceLine line;
  bool visible = true;
};

/// Finds the lines of a surface. What does not depend on the view is found once. Lengths are in normalised units but
/// for those of the parameters.
class LineDrawing {
 public:
  /// `noise` (ē): standard deviation along the normal, for the creases. The arguments must outlive this.
  /// \throw what require_drawable() throws; Cancelled
  LineDrawing(const Surface& surface, const Topology& topology, const DifferentiatedField& field, double noise,
              const LineDrawingParameters& parameters, Execution& execution);

  /// The lines of a view, in the order of their kinds. \throw Cancelled
  std::vector<ViewLine> lines_of(const View& view, Execution& execution) const;

 private:
  void find_edges(double noise, Execution& execution);
  void find_extrema(Execution& execution);
  void find_sections(Execution& execution);
  void find_hatching(Execution& execution);
  std::vector<SurfaceLine> lines_seen_from(const View& view, Execution& execution) const;
  void add(const std::vector<SurfaceLine>& lines, std::vector<SurfaceLine>& all) const;
  std::vector<SurfaceLine> zeros(const LineScalar& scalar, Execution& execution) const;

  const Surface& surface_;
  const Topology& topology_;
  const DifferentiatedField& field_;
  LineDrawingParameters parameters_;
  LineSelection selection_;
  std::vector<SurfaceLine> fixed_lines_;     ///< smoothed
  std::vector<SurfaceLine> hatching_lines_;  ///< of all of the surface: what is dark depends on the view
};

}  // namespace integral_invariant
