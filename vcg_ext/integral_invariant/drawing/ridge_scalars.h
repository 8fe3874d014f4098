// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: the functions whose zeros are ridges, valleys, apparent ridges and demarcating curves.
#pragma once

#include "integral_invariant/drawing/line_scalars.h"

namespace integral_invariant {

/// Ridges (Ohtake et al. 2004): κ_max has a maximum along dir_max, and κ_max > |κ_min|; valleys are the ridges of the
/// complement. z: the smaller of κ and of its second derivative, over their standard errors. Strength: |κ|.
LineScalar ridge_scalar(const Surface& surface, const DifferentiatedField& field, LineKind kind, Execution& execution);

/// Apparent ridges (Judd et al. 2007): q1, the largest singular value of Q = S (I + (secθ − 1) w wᵀ), has a maximum
/// along its singular vector t1, on the front. z and strength: as for ridges, of q1.
LineScalar apparent_ridge_scalar(const Surface& surface, const DifferentiatedField& field, const View& view,
                                 Execution& execution);

/// Demarcating curves (Kolomenkin et al. 2008): II(g, g) = 0, where g is the unit vector that maximises C(g, g, g).
/// z: C(g, g, g) over its standard error, less what choosing the maximum adds, and no more than the change of the
/// curvature from the line to one width of the fits beside it, over its own. Strength: C(g, g, g).
LineScalar demarcating_scalar(const DifferentiatedField& field, Execution& execution);

/// The angle in the principal frame at which C(g, g, g) is largest.
double steepest_angle(const CurvatureDerivative& c);

/// q1 and t1 (in the principal frame) of the curvatures `kappa_max`, `kappa_mixed`, `kappa_min`, seen from a viewer
/// with the tangential part (x, y) and the cosine c.
struct ApparentCurvature {
  double q1 = 0;
  double t1_x = 1, t1_y = 0;
};
ApparentCurvature apparent_curvature(double kappa_max, double kappa_mixed, double kappa_min, double x, double y,
                                     double cosine);

}  // namespace integral_invariant
