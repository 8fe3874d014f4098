// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: quadrics through the vertices of discs, for balls that do not see one sheet alone.
#pragma once

#include <vector>

#include "integral_invariant/ball_curvature/tensor_field.h"
#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/multiscale/creases.h"
#include "integral_invariant/multiscale/noise_level.h"
#include "integral_invariant/multiscale/valid_scales.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// Three standard deviations of what a fit to vertices says: its curvature, its normal.
struct ThreeSigma {
  double curvature = 0, normal = 0;
};
ThreeSigma three_sigma_of(const DiscVariance& variance, double sigma);

/// Whether the surface turns away within this ball or disc, so that larger ones say nothing.
bool exceeds_graph_limit(const CurvatureTensor& tensor, double radius, const ThreeSigma& doubt);

/// n flags, or nothing where no small ball meets another sheet: vertices where one does and a disc along the edges is
/// smooth. What looks like a crease there is the other sheet. `normals` are those of patches. Cost about 2 µs a vertex
/// whose small balls meet another sheet.
std::vector<char> find_single_sheets(const Surface& surface, const std::vector<Vec3>& normals, const NoiseLevel& noise,
                                     bool removes_bias, const TensorField& tensors, const ValidScales& balls,
                                     Execution& execution);

/// Discs that end at creases for all balls that are not a vertex's own; of those that are doubted, only where the disc
/// is a good one and says something else. Leaves none doubted. Changes `tensors` where the origin becomes vertices.
/// Cost about 15 µs a vertex whose largest balls give way.
void fall_back_to_jets(const Surface& surface, const std::vector<Vec3>& normals, const NoiseLevel& noise,
                       const Creases& creases, bool removes_bias, TensorField& tensors, ValidScales& balls,
                       Execution& execution);

}  // namespace integral_invariant
