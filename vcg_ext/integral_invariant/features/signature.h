// SPDX-License-Identifier: GPL-3.0-or-later
// Features: integral invariants at all scales as a signature of the surface around each vertex.
#pragma once

#include <vector>

#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/parameters.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

enum class SignatureQuantity {
  volume = 0,  ///< 1 − 2 V / (4/3 π r³): −1 (all solid) over 0 (flat) to 1 (nothing solid); positive where convex
  mean = 1,    ///< (κ_max + κ_min) / 2, 1/L, positive where convex
  difference = 2,  ///< κ_max − κ_min, 1/L, never negative
};
inline constexpr int signature_quantity_count = 3;

/// One entry a scale and vertex; all finite; zeros for vertices without a triangle.
struct Signature {
  std::vector<double> radii;                                         ///< of the scales, L
  std::vector<std::vector<float>> values[signature_quantity_count];  ///< [quantity][scale][vertex]
  SurfaceReport surface;
  double average_edge = 0, diagonal = 0;  ///< L
  std::string engine;
  std::vector<StageTime> stages;

  const std::vector<std::vector<float>>& of(SignatureQuantity quantity) const { return values[int(quantity)]; }
};

/// The signature of every vertex at the scales of `parameters`; radius_choice must be feature_adapted (all scales).
/// \throw ParameterError, InputError, MemoryError, Cancelled as compute_curvature() does
Signature compute_signature(const TriangleMesh& mesh, const Parameters& parameters,
                            const ProgressCallback& progress = {});

/// How the values over the scales become one number.
enum class Reduction {
  one_scale = 0,
  minimum = 1,
  maximum = 2,
  p_norm = 3,  ///< (mean of |value|^p over the scales)^(1/p): not negative, and of the size of the values
};

struct ReductionParameters {
  SignatureQuantity quantity = SignatureQuantity::volume;
  Reduction reduction = Reduction::one_scale;
  int scale = 1;  ///< of one_scale, 1 to the number of scales
  double p = 2;   ///< of p_norm, at least 1
};

/// \throw ParameterError where the scale or p is out of range
std::vector<double> reduce(const Signature& signature, const ReductionParameters& parameters);

}  // namespace integral_invariant
