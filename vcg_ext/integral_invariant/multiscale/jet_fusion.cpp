// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: the chain's last step. In: chain result, fits to the vertices. Out: the result with the fits weighed in.
// Cost: O(n), one average over the neighbourhood. Source: docs/method.md §11.
#include "integral_invariant/multiscale/jet_fusion.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

void fuse_jets(const JetObservation& fitted, const KernelSum& pool, FilteredSignal& result, Execution& execution)
{
  constexpr double largest_energy = 25, evident_energy = 12, least_share = 1.5, undeniable_energy = 40;
  constexpr double least_noise = 1e-30;  // of fits that are exact: energies stay finite
  const std::size_t n = fitted.values.size();
  const int strands = gain_group_count(fitted.components, fitted.evidence), of_each = fitted.components / strands;
  std::vector<std::array<double, 3>> energies;
  std::vector<std::array<double, 2>> own;
  resize_in_steps(energies, n, execution);
  resize_in_steps(own, n, execution);
  for_each_index(n, execution, [&](std::size_t v) {
    energies[v] = {};
    own[v] = {};
    if (!std::isfinite(fitted.noise[v])) return;
    energies[v][0] = 1;
    for (int k = 0; k < strands; ++k) {
      for (int c = k * of_each; c < (k + 1) * of_each; ++c)
        own[v][k] += std::pow(fitted.values[v][c] - result.value[v][c], 2);
      own[v][k] /= of_each * (fitted.noise[v] + least_noise);
      energies[v][1 + k] = std::min(own[v][k], largest_energy);
    }
  });
  pool.splat_and_slice(energies, execution);
  for_each_index(n, execution, [&](std::size_t v) {
    if (!std::isfinite(fitted.noise[v])) return;
    for (int k = 0; k < strands; ++k) {
      double shape = energies[v][1 + k] / energies[v][0] - 1;
      if (shape < least_share && own[v][k] < undeniable_energy) continue;
      shape = std::max(shape, own[v][k] - evident_energy);
      const double weight = shape / (shape + 1);
      for (int c = k * of_each; c < (k + 1) * of_each; ++c) {
        result.value[v][c] += weight * (fitted.values[v][c] - result.value[v][c]);
        result.variance[v][c] = weight * fitted.error[v];
      }
    }
  });
}

}  // namespace integral_invariant
