// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 4: bilateral smoothing of the radius. In and out: a radius per vertex. Cost: O(n) a pass. Source: [Lai09 eq.
// 9].
#include "integral_invariant/published/radius_smoothing.h"

#include <cmath>
#include <cstdint>

namespace integral_invariant {

namespace {

constexpr std::size_t grain = 2048;

/// σ₂ = average |Δr| along the edges. Summed in vertex order by one thread: the same bits whatever the threads.
double average_difference(const Surface& surface, const std::vector<double>& radii, Execution& execution)
{
  const auto& start = surface.neighbour_start();
  const auto& neighbours = surface.neighbours();
  double sum = 0;
  std::size_t edges = 0;
  for_each_in_order(radii.size(), execution, [&](std::size_t v) {
    for (std::uint32_t e = start[v]; e < start[v + 1]; ++e)
      if (neighbours[e] > v) {
        sum += std::abs(radii[neighbours[e]] - radii[v]);
        ++edges;
      }
  });
  return edges ? sum / double(edges) : 0;
}

}  // namespace

std::vector<double> smooth_radii(const Surface& surface, std::vector<double> radii, int passes, Execution& execution)
{
  const auto& positions = surface.positions();
  const auto& start = surface.neighbour_start();
  const auto& neighbours = surface.neighbours();
  constexpr double inverse_spatial = 0.5;  // 1/(2σ₁²) with σ₁ the average edge length, which is 1

  std::vector<double> smoothed(radii.size());
  for (int pass = 0; pass < passes; ++pass) {
    const double range_sigma = average_difference(surface, radii, execution);
    if (!(range_sigma > 0)) break;  // the radius is constant
    const double inverse_range = 1 / (2 * range_sigma * range_sigma);
    parallel_for(
        radii.size(), grain, execution,
        [&](std::size_t begin, std::size_t end, int) {
          for (std::size_t v = begin; v < end; ++v) {
            double sum = radii[v], weights = 1;
            for (std::uint32_t e = start[v]; e < start[v + 1]; ++e) {
              const std::uint32_t u = neighbours[e];
              const double difference = radii[u] - radii[v];
              const double weight = std::exp(-squared_norm(positions[u] - positions[v]) * inverse_spatial -
                                             difference * difference * inverse_range);
              sum += weight * radii[u];
              weights += weight;
            }
            smoothed[v] = sum / weights;
          }
        },
        double(pass) / passes, double(pass + 1) / passes);
    radii.swap(smoothed);
  }
  return radii;
}

}  // namespace integral_invariant
