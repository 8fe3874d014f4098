// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: the scale chain's last step, from the smallest ball to the vertices themselves.
#pragma once

#include <array>
#include <vector>

#include "integral_invariant/multiscale/scale_filter.h"
#include "integral_invariant/support/kernel_sum.h"

namespace integral_invariant {

/// A quantity of up to two components as the fits to the vertices give it (jet_fit.h).
struct JetObservation {
  int components;
  GainSharing evidence;
  std::vector<std::array<double, 2>> values;  ///< n
  std::vector<double> noise;                  ///< n: variance of either component; infinite where there is no fit
  std::vector<double> error;                  ///< n: the same with what shape of a higher degree may add
};

/// A fit to the vertices sees no flat triangles and has almost no bias, but the most noise of all: it is added to the
/// chain's result as one more scale, x̂ + w (Y − x̂) with w = P/(P + N), N the fit's noise and P/N the mean over the
/// neighbourhood of |Y − x̂|²/N less 1. Without noise w is 1. Cost O(n).
void fuse_jets(const JetObservation& fitted, const KernelSum& pool, FilteredSignal& result, Execution& execution);

}  // namespace integral_invariant
