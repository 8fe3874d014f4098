// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: what fits to the vertices say, as the scale chain's last step takes it.
#pragma once

#include <vector>

#include "integral_invariant/ball_curvature/tangent_frame.h"
#include "integral_invariant/jets/jet_fit.h"
#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/multiscale/jet_fusion.h"
#include "integral_invariant/multiscale/noise_level.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

struct JetObservations {
  JetObservation mean, deviator, normal;
};

/// Of `fits` (JetFitter::nearest() at all vertices), and where next to nothing of what they leave over is noise, of
/// JetFitter::finest() instead. None at vertices where fits reach over a crease. Cost O(n); without noise about 10
/// µs a vertex.
JetObservations observe_jets(const Surface& surface, const std::vector<Jet>& fits,
                             const std::vector<TangentFrame>& frames, const NoiseLevel& noise, Execution& execution);

}  // namespace integral_invariant
