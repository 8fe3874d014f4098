// SPDX-License-Identifier: GPL-3.0-or-later
// Features: crest lines, where the surface bends most sharply across a line.
#pragma once

#include <vector>

#include "integral_invariant/features/curvature_field.h"
#include "integral_invariant/features/ridges_valleys.h"
#include "integral_invariant/features/surface_point.h"

namespace integral_invariant {

struct CrestLineParameters {
  bool ridges = true, valleys = true;
  int smoothing_passes = 3;        ///< of the curvatures over the mesh, before their derivative is taken
  double minimum_strength = 1;     ///< see CrestLine::strength
  double minimum_length = 0;       ///< L; 0: five average edge lengths
  double minimum_sharpness = 0.3;  ///< see CrestLine::sharpness
};

/// A polyline of extrema. Its points lie on edges of the mesh, one a crossing.
struct CrestLine {
  FeatureKind kind = FeatureKind::ridge;
  std::vector<SurfacePoint> points;
  bool closed = false;  ///< the last point is joined to the first
  double length = 0;    ///< L
  double strength = 0;  ///< ∫ |κ| ds along the line: no unit. 1: as long as the radius it bends around
  /// Median along the line of −κ″/κ³ across it (its ends may run into a crease, beside which κ is far larger): no unit.
  /// Cylinder and sphere 0, end of an ellipse a > b: 3 (1 − b²/a²). κ″ is the second difference over half the radius
  /// 1/κ to both sides: over an edge length it would be all noise.
  double sharpness = 0;
};

/// Ridge lines: κ_max has a maximum along d_max, and κ_max > |κ_min|. Valley lines: the same of the solid's complement.
/// The derivative is that of linear finite elements, averaged at the vertices; its sign changes are found on the edges
/// with the directions of each triangle signed alike, and joined through the triangles to lines. `field` is in
/// normalised units and belongs to `surface`. Strongest first. Cost: O(m log m). \throw ParameterError where there are
/// too many passes; Cancelled
std::vector<CrestLine> find_crest_lines(const Surface& surface, const CurvatureField& field,
                                        const CrestLineParameters& parameters, Execution& execution);

}  // namespace integral_invariant
