// SPDX-License-Identifier: GPL-3.0-or-later
// This library, run on a mesh of the benchmark.
#pragma once

#include "estimate.h"
#include "integral_invariant/curvature.h"

namespace accuracy {

struct OwnResult {
  Metrics metrics;
  double noise = 0;         ///< estimated standard deviation, in the mesh's unit
  double average_edge = 0;  ///< of the mesh, in its unit
  double seconds = 0;       ///< by the clock
};

/// Runs compute_curvature() and judges it at the judged vertices of `truth`.
OwnResult measure_own(const TruthMesh& truth, const integral_invariant::Parameters& parameters);

}  // namespace accuracy
