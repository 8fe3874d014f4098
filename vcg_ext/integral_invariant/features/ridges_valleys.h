// SPDX-License-Identifier: GPL-3.0-or-later
// Features: regions where the surface bends strongly [Lai09 §5].
#pragma once

#include <cstdint>
#include <vector>

#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/result.h"

namespace integral_invariant {

enum class FeatureKind : std::int8_t { valley = -1, none = 0, ridge = 1 };

/// How strong is strong.
enum class FeatureThreshold {
  percentile = 0,  ///< relative to max(|κ_max|, |κ_min|) of the vertices: the strongest (100 − p) % pass
  curvature = 1,   ///< absolute, 1/L
};

struct RidgeValleyParameters {
  bool ridges = true, valleys = true;
  FeatureThreshold threshold = FeatureThreshold::percentile;
  double high_percentile = 95, low_percentile = 88;  ///< in [0, 100], low ≤ high
  double high_curvature = 0;                         ///< 1/L, above 0 where thresholds are absolute
  double low_curvature = 0;                          ///< 1/L, at most high_curvature; 0: half of it
  int minimum_vertices = 10;                         ///< smaller regions are dropped
  double minimum_area = 0;                           ///< L²; smaller regions are dropped
};

/// One connected region of a single kind.
struct FeatureRegion {
  FeatureKind kind;
  std::size_t vertices = 0;
  double area = 0;  ///< L²
  double peak = 0;  ///< largest κ_max of a ridge, largest −κ_min of a valley, 1/L
};

struct RidgeValleyRegions {
  std::vector<FeatureKind> kind;       ///< of every vertex
  std::vector<std::int32_t> region;    ///< index into regions, -1 for none
  std::vector<FeatureRegion> regions;  ///< in the order of their first vertex
  double high = 0, low = 0;            ///< the thresholds that were used, 1/L
};

/// Ridges: κ_max ≥ t; valleys: κ_min ≤ −t; a vertex that is both takes the kind of the larger |κ|. With hysteresis: a
/// region holds the vertices above `low` that are connected through mesh edges, inside the region, to one above `high`.
/// `result` belongs to the mesh that `surface` was made from. Cost: O(n).
/// \throw Cancelled, or ParameterError where a threshold is out of its range, or the low one is over the high one
RidgeValleyRegions find_ridges_and_valleys(const Surface& surface, const Result& result,
                                           const RidgeValleyParameters& parameters, Execution& execution);

}  // namespace integral_invariant
