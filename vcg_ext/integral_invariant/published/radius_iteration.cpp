// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: the feature-adapted radius. In: curvature tensors at all scales. Out: a radius per vertex.
// Cost: O(iterations) a vertex, about 50 ns each. Source: [Lai09 4.2, eq. 7 and 8].
#include "integral_invariant/published/radius_iteration.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

namespace integral_invariant {

namespace {

constexpr std::size_t grain = 512;

/// Median of the smallest principal radii over the scales; the mean of the middle two where n is even.
double median_principal_radius(const TensorField& tensors, std::size_t vertex, std::vector<double>& scratch)
{
  const int n = int(tensors.radii().size());
  scratch.resize(n);
  const double largest = tensors.radii().back();
  for (int i = 0; i < n; ++i) {
    const double kappa = largest_absolute_curvature(tensors.at_scale(vertex, i));
    // Flat scales count as the largest radius, so that the mean of two stays finite.
    scratch[i] = kappa * largest > 1 ? 1 / kappa : largest;
  }
  std::sort(scratch.begin(), scratch.end());
  return (scratch[(n - 1) / 2] + scratch[n / 2]) / 2;
}

struct Iterated {
  double radius;
  int iterations;
  bool converged;
};

Iterated iterate(const TensorField& tensors, std::size_t vertex, double r, const Parameters& p)
{
  const double low = tensors.radii().front(), high = tensors.radii().back();
  for (int i = 0; i < p.max_iterations; ++i) {
    const double kappa = largest_absolute_curvature(tensors.at_radius(vertex, r));
    const double target = kappa * low > p.alpha ? low : kappa * high < p.alpha ? high : p.alpha / kappa;
    const double change = p.step * (target - r);
    r += change;
    if (std::abs(change) < p.tolerance * r) return {r, i + 1, true};
  }
  return {r, p.max_iterations, p.max_iterations == 0};
}

}  // namespace

std::vector<double> start_radii(const TensorField& tensors, StartRadius rule, Execution& execution)
{
  const double low = tensors.radii().front(), high = tensors.radii().back();
  std::vector<double> radii(tensors.vertex_count(), (low + high) / 2);
  if (rule == StartRadius::middle) return radii;
  parallel_for(radii.size(), grain, execution, [&](std::size_t begin, std::size_t end, int) {
    std::vector<double> scratch;
    for (std::size_t v = begin; v < end; ++v)
      radii[v] = std::clamp(median_principal_radius(tensors, v, scratch), low, high);
  });
  return radii;
}

AdaptedRadii adapt_radii(const TensorField& tensors, std::vector<double> start, const Parameters& parameters,
                         Execution& execution)
{
  AdaptedRadii result;
  result.radius = std::move(start);
  std::vector<int> iterations(result.radius.size());
  std::atomic<std::size_t> converged{0};
  parallel_for(result.radius.size(), grain, execution, [&](std::size_t begin, std::size_t end, int) {
    std::size_t count = 0;
    for (std::size_t v = begin; v < end; ++v) {
      const Iterated end_state = iterate(tensors, v, result.radius[v], parameters);
      result.radius[v] = end_state.radius;
      iterations[v] = end_state.iterations;
      count += end_state.converged;
    }
    converged += count;
  });
  result.converged = converged;
  if (!iterations.empty()) {
    result.largest_iterations = *std::max_element(iterations.begin(), iterations.end());
    result.mean_iterations =
        double(std::accumulate(iterations.begin(), iterations.end(), 0LL)) / double(iterations.size());
  }
  return result;
}

}  // namespace integral_invariant
