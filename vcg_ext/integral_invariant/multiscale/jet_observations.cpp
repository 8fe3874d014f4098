// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: signals of fits. In: fits to the vertices, noise. Out: their components with noise and error. Cost: O(n);
// without noise about 10 µs a vertex. Source: docs/method.md §6.
#include "integral_invariant/multiscale/jet_observations.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace integral_invariant {

namespace {

/// Of the noise's variance, so that without noise fits are not divided by nothing.
constexpr double least_variance = 1e-20;

/// Fits that reach over a crease, and those beside them: a polynomial overshoots it, and swings to both sides of it.
std::vector<char> near_creases(const Surface& surface, const std::vector<Jet>& fits, Execution& execution)
{
  constexpr double largest_kr = 1.3;
  std::vector<char> near(fits.size(), 0);
  for_each_in_order(fits.size(), execution, [&](std::size_t v) {
    if (!(largest_absolute_curvature(fits[v].tensor) * fits[v].support_radius > largest_kr)) return;
    near[v] = 1;
    for (std::uint32_t e = surface.neighbour_start()[v]; e < surface.neighbour_start()[v + 1]; ++e)
      near[surface.neighbours()[e]] = 1;
  });
  return near;
}

class Signals {
 public:
  Signals(std::size_t n, Execution& execution)
      : result_{
            {1, GainSharing::joint, {}, {}, {}}, {2, GainSharing::each, {}, {}, {}}, {2, GainSharing::each, {}, {}, {}}}
  {
    for (JetObservation* signal : {&result_.mean, &result_.deviator, &result_.normal}) {
      resize_in_steps(signal->values, n, execution);
      resize_in_steps(signal->error, n, execution);
      resize_in_steps(signal->noise, n, execution, double(INFINITY));
    }
  }

  /// \param noise variance of the vertices about the polynomial that is noise \param error all of it
  void set(std::size_t v, const Jet& fit, const TangentFrame& frame, double noise, double error,
           const NoiseTransfer& transfer)
  {
    const TensorComponents c = components_of(fit.tensor, frame);
    result_.mean.values[v] = {c.mean, 0};
    result_.deviator.values[v] = c.deviator;
    result_.normal.values[v] = c.tilt;
    const std::pair<JetObservation*, double> parts[] = {{&result_.mean, fit.mean_variance},
                                                        {&result_.deviator, fit.deviator_variance},
                                                        {&result_.normal, fit.normal_variance}};
    for (const auto& [signal, of_part] : parts) {
      const double ratio =
          signal == &result_.normal ? transfer.normal_ratio_of(of_part) : transfer.curvature_ratio_of(of_part);
      signal->noise[v] = of_part * ratio * std::max(noise, least_variance);
      signal->error[v] = of_part * ratio * std::max(error, least_variance);
    }
  }

  JetObservations result() { return std::move(result_); }

 private:
  JetObservations result_;
};

}  // namespace

JetObservations observe_jets(const Surface& surface, const std::vector<Jet>& fits,
                             const std::vector<TangentFrame>& frames, const NoiseLevel& noise, Execution& execution)
{
  constexpr double evident_residual = 6, least_shape_share = 0.9;
  const std::size_t n = fits.size();
  const std::vector<char> is_near_crease = near_creases(surface, fits, execution);
  Signals signals(n, execution);
  JetFitters fitters(surface, execution);
  parallel_step(n, 256, execution, [&](std::size_t begin, std::size_t end, int worker) {
    for (std::size_t v = begin; v < end; ++v) {
      if (!(fits[v].tensor.confidence > 0) || is_near_crease[v] || noise.defies_jets[v]) continue;
      double variance = noise.sigma[v] * noise.sigma[v];
      if (noise.lack_of_fit[v] > least_shape_share) {
        const Jet fit = fitters.of(worker).finest(v, fits[v]);
        signals.set(v, fit, frames[v], 0, fit.residual_variance >= 0 ? fit.residual_variance : variance,
                    noise.transfer);
      } else {
        const Jet& fit = fits[v];
        if (fit.residual_variance > evident_residual * variance) variance = fit.residual_variance;
        signals.set(v, fit, frames[v], variance, variance, noise.transfer);
      }
    }
  });
  return signals.result();
}

}  // namespace integral_invariant
