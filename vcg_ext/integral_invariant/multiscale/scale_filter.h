// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: one quantity, measured at all scales, estimated at radius 0 by its evidence.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "integral_invariant/multiscale/valid_scales.h"
#include "integral_invariant/support/execution.h"
#include "integral_invariant/support/kernel_sum.h"
#include "integral_invariant/support/zeroed_array.h"

namespace integral_invariant {

/// Whether two components are added together by what they show between them, or each by what it shows alone.
enum class GainSharing { joint, each };
/// How many groups of components have weights of their own.
inline int gain_group_count(int components, GainSharing evidence)
{
  return evidence == GainSharing::each ? components : 1;
}

/// A quantity of up to two components, measured at every scale of every vertex, with noise whose differences between
/// scales are independent (see disc_variance).
struct Signal {
  Signal(int component_count, GainSharing how, std::size_t places)
      : components(component_count), evidence(how), values(places), noise(places)
  {
  }
  int components;
  GainSharing evidence;
  ZeroedArray<std::array<float, 2>> values;  ///< n × scales
  ZeroedArray<float> noise;                  ///< n × scales: variance of either component
};

/// What all signals of a run share.
struct FilterContext {
  const std::vector<double>& radii;
  const ValidScales& balls;
  const std::vector<double>& least_radius;  ///< n: smaller balls are not linear in the noise and say nothing
  const std::vector<KernelSum>& pools;      ///< one a scale but the largest, for averages over the neighbourhood
  bool predict;                             ///< whether a scale is predicted from the larger one: removes bias
};

struct FilteredSignal {
  std::vector<std::array<double, 2>> value;     ///< n
  std::vector<std::array<double, 2>> variance;  ///< n: expected squared error of each component
  std::vector<double> radius;                   ///< n: of the ball that alone would smooth the first one as much
};

/// From the largest scale down, the estimate grows by the estimated differences between neighbouring scales: x̂ = Y_top
/// + Σ d̂_i, d̂_i = β_i d̂_{i+1} + w_i (Y_i − Y_{i+1} − β_i d̂_{i+1}).
///
/// A Kalman filter whose model is measured on the surface itself: β_i, how much of a difference follows from the one
/// before (bias grows as r², which makes it (r_{i+1}² − r_i²)/(r_{i+2}² − r_{i+1}²); more where balls are as large as
/// the bumps), is a regression over the neighbourhood; w_i = P/(P + N) with N the noise's variance and P the mean
/// square of the innovations over the neighbourhood less N. Where a scale shows nothing but noise P is 0 and nothing
/// is added; where it shows shape w is 1 and the larger scales cancel. Below the smallest scale the bias is
/// extrapolated as r².
class ScaleFilter {
 public:
  ScaleFilter(const FilterContext& evidence, Execution& execution);
  ~ScaleFilter();

  /// Cost O(n · scales), about 0.1 µs a vertex and scale; scratch memory is kept for the next signal. \throw Cancelled
  FilteredSignal run(const Signal& signal);

 private:
  class Filter;
  std::unique_ptr<Filter> filter_;
};

}  // namespace integral_invariant
