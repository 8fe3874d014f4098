// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: curvatures as the result of a filter.
#pragma once

#include "filter_result.h"
#include "request.h"

namespace integral_invariant::filter {

/// Curvatures, with a quantity made of them as quality and colour.
///
/// The log: vertices, scales, engine, convergence, quality, defects of the mesh, seconds. The same for programs:
/// vertices, triangles, scales, median_radius, converged, low_confidence, seconds, ..., and for each quantity
/// <key>_min, _p5, _median, _p95, _max.
FilterResult curvature_result(Result curvature, const OutputOptions& options);

}  // namespace integral_invariant::filter
