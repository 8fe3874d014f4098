// SPDX-License-Identifier: GPL-3.0-or-later
// Features: the principal curvatures and directions of the vertices, as the feature stages read them.
#pragma once

#include <vector>

#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/result.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// κ_max ≥ κ_min in normalised units (1/ē) with their unit directions, one entry a vertex; directions have no sign.
struct CurvatureField {
  std::vector<double> kappa_max, kappa_min;
  std::vector<Vec3> dir_max, dir_min, normal;

  std::size_t size() const { return kappa_max.size(); }
};

/// The field of a run, in normalised units.
CurvatureField curvature_field(const Result& result);

/// Averages the curvature tensors over each vertex and its neighbours, `passes` times; as tensors, because directions
/// have no sign and turn quickly near umbilics. The radius of the balls changes from vertex to vertex and leaves steps
/// of its own in the field, which a derivative would see. Cost: O(n) a pass. Covers the stage up to the fraction `to`.
CurvatureField smoothed(const Surface& surface, CurvatureField field, int passes, Execution& execution, double to = 1);

}  // namespace integral_invariant
