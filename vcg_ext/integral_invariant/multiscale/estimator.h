// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: curvature from all scales at once, each weighted by what it shows over its noise.
#pragma once

#include <vector>

#include "integral_invariant/ball_curvature/tensor_field.h"
#include "integral_invariant/jets/jet_fit.h"
#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/multiscale/noise_level.h"
#include "integral_invariant/parameters.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// One entry a vertex, normalised units.
struct MultiscaleCurvature {
  std::vector<CurvatureTensor> tensor;
  std::vector<double> standard_error;  ///< of either principal curvature
  std::vector<double> radius;          ///< of the ball that alone would smooth the mean curvature as much
};

/// Mean curvature, deviator and normal each go through a scale chain of their own (scale_filter.h): they have different
/// noise and different bias. What lies along and what lies across the principal direction of a vertex's largest ball is
/// added apart: curvatures may change with the scale where directions do not. What the largest disc does not know of a
/// curvature is shrunk (tensor_prior.h). `tensors` are offset-free, `offsets`
/// theirs (n × scales); with Estimator::bias_free they lose their own bias first, and scales predict each other.
/// Changes `tensors`. Cost O(n · scales), about 0.4 µs a vertex and scale; more where discs of vertices replace balls.
MultiscaleCurvature estimate_multiscale(const Surface& surface, TensorField& tensors, const std::vector<float>& offsets,
                                        const std::vector<Jet>& fits, const NoiseLevel& noise, Estimator estimator,
                                        Execution& execution);

}  // namespace integral_invariant
