// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: the functions of the vertices whose zeros are the lines of each kind.
#pragma once

#include <vector>

#include "integral_invariant/drawing/field_derivative.h"
#include "integral_invariant/drawing/surface_line.h"
#include "integral_invariant/drawing/view.h"

namespace integral_invariant {

/// One entry a vertex. The line runs where `value` is zero and `significance` is high enough.
struct LineScalar {
  LineKind kind = LineKind::contour;
  std::vector<double> value;
  std::vector<double> significance;  ///< z; 0 where there can be no line
  std::vector<double> strength;
  /// The direction that the value was taken along, empty where there is none. Ends of an edge whose directions are more
  /// than 60 degrees apart have no zero between them.
  std::vector<Vec3> direction;
  /// Whether directions have no sign and the value changes its sign with theirs: lines are maxima along the direction
  /// then, so that the value falls along it.
  bool is_derivative = false;
};

/// Occluding contours: n·v = 0. All are significant: what noise adds on a flat face that is seen from its edge lies on
/// the face's line in the picture. Strength: the radial curvature κ_r, negative where the surface itself hides the
/// contour for certain.
LineScalar contour_scalar(const DifferentiatedField& field, const View& view, Execution& execution);

/// Suggestive contours (DeCarlo et al. 2003): κ_r = 0 on the front, D_w κ_r > 0; as highlights (DeCarlo and
/// Rusinkiewicz 2007), D_w κ_r < 0. z: sinθ · |D_w κ_r| over its standard error, and no more than the change of κ_r
/// over the reach of the local fits over the error of the curvature: on flat parts noise has zeros everywhere.
/// Strength: |D_w κ_r|.
LineScalar suggestive_scalar(const DifferentiatedField& field, const View& view, LineKind kind, Execution& execution);

/// The plane dot(p, normal) = offset, in normalised units, cut with the fitted surface.
LineScalar section_scalar(const DifferentiatedField& field, const Vec3& normal, double offset, Execution& execution);

/// κ_r sin²θ, and sinθ · D_w κ_r with its standard error, at a vertex seen from `toward`.
struct RadialCurvature {
  double cosine = 0, squared_sine = 0;  ///< of θ, the angle between normal and viewer
  double scaled = 0;                    ///< κ_r sin²θ
  double derivative = 0, derivative_error = 0;
};
RadialCurvature radial_curvature(const DifferentiatedField& field, std::size_t v, const Vec3& toward);

}  // namespace integral_invariant
