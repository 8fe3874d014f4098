// SPDX-License-Identifier: GPL-3.0-or-later
// The estimator of the classic programs for line drawings [Rusinkiewicz 2004]: curvature of each triangle from the
// normals of its vertices, its derivative from their tensors, both averaged at the vertices; and a slider that smooths
// normals, curvatures and derivatives.
#pragma once

#include "integral_invariant/drawing/field_derivative.h"

namespace line_benchmark {

/// `smoothing`: standard deviation in ē of the Gaussian weights over the mesh; 0: none. Positions are those of the
/// mesh. The errors are 1, so that significance is the quantity itself.
integral_invariant::DifferentiatedField classic_field(const integral_invariant::Surface& surface, double smoothing);

}  // namespace line_benchmark
