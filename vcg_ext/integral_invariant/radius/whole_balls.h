// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: which scales of a vertex can be trusted, and substitutes for those that reach over a boundary.
#pragma once

#include <vector>

#include "integral_invariant/curvature/scale_blend.h"
#include "integral_invariant/support/execution.h"
#include "integral_invariant/surface.h"

namespace integral_invariant {

/// Where the tensor of a (vertex, scale) comes from.
enum class Origin : unsigned char { none, neighbours, own };

struct WholeBalls {
  std::vector<Origin> origin;  ///< n × scales
  std::vector<int> largest;    ///< n: the largest scale to be used
};

/// A ball that misses more than a twentieth of its disc (the surface ends there) gets the average tensor and normal of the
/// whole balls of its size around it, each carried to the vertex along its own curvature. A vertex's largest scale is the one before
/// balls stop being nearly a half: where |κ| r passes 1.3 or the normal turns away, because the ball meets a crease,
/// another sheet, or the whole of a small part. Changes `tensors` where the origin is neighbours. Cost O(n · scales).
WholeBalls find_whole_balls(const Surface& surface, TensorField& tensors, Execution& execution);

}  // namespace integral_invariant
