// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: creases. In: tensors of two small scales, noise. Out: crease vertices, distance of all others to them.
// Cost: O(n), and O(n log n) where there are creases. Source: Dijkstra's method; docs/method.md §8.
#include "integral_invariant/multiscale/creases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>

#include "integral_invariant/ball_curvature/offset_free.h"
#include "integral_invariant/multiscale/valid_scales.h"
#include "integral_invariant/support/kernel_sum.h"

namespace integral_invariant {

namespace {

/// Three standard deviations of |κ|r.
double doubt_of_fold(double r, double density, const NoiseTransfer& transfer)
{
  constexpr double deviations = 3;
  return deviations *
         std::sqrt((disc_variance::mean_curvature + disc_variance::deviator) * density * transfer.curvature_ratio(r)) /
         (r * r);
}

/// What |κ| has to do from a scale to the next larger one.
bool is_fold(std::size_t v, int scale, double least_fall, const TensorField& tensors, const NoiseLevel& noise)
{
  constexpr double least_kr = 0.5;
  const CurvatureTensor small = tensors.at_scale(v, scale), large = tensors.at_scale(v, scale + 1);
  if (small.confidence < least_confidence || large.confidence < least_confidence) return false;
  const double r = tensors.radii()[std::size_t(scale)], k = largest_absolute_curvature(small);
  if (r < least_radius_over_sigma * noise.sigma[v]) return false;
  return k * r - doubt_of_fold(r, noise.density[v], noise.transfer) > least_kr &&
         k > least_fall * largest_absolute_curvature(large);
}

/// In larger balls smooth parts of the same size look the same; under noise there is nothing else.
bool is_fold(std::size_t v, int scale, const TensorField& tensors, const NoiseLevel& noise)
{
  constexpr double least_fall = 1.3, largest_doubt = 0.5;
  constexpr double noisy_fall = 1.4, largest_noisy_radius = 4;
  const std::vector<double>& radii = tensors.radii();
  const auto radius = [&](int i) { return radii[std::size_t(i)]; };
  const bool is_noisy = doubt_of_fold(radius(scale), noise.density[v], noise.transfer) > largest_doubt;
  if (is_noisy && scale + 2 < int(radii.size()) && radius(scale + 1) < largest_noisy_radius)
    return is_fold(v, scale + 1, noisy_fall, tensors, noise);
  return is_fold(v, scale, least_fall, tensors, noise);
}

bool is_polynomial(const Jet& fit)
{
  constexpr double largest_residual = 0.02, largest_kr = 1.3;
  return fit.tensor.confidence > 0 && fit.residual_variance >= 0 &&
         fit.residual_variance < largest_residual * largest_residual &&
         largest_absolute_curvature(fit.tensor) * fit.support_radius < largest_kr;
}

bool has_any(const std::vector<char>& flags) { return std::find(flags.begin(), flags.end(), 1) != flags.end(); }

/// Creases are lines, and a third of the vertices around them is theirs. Under noise a rod no thicker than the balls
/// looks like a crease all over, and smooth parts do here and there by chance.
void keep_lines(const Surface& surface, const NoiseLevel& noise, double radius, std::vector<char>& is_crease,
                Execution& execution)
{
  constexpr double least_doubt = 0.25, least_share = 0.05, largest_share = 0.5, pool_cell = 6.5;
  const auto is_doubted = [&](std::size_t v) {
    return doubt_of_fold(radius, noise.density[v], noise.transfer) > least_doubt;
  };
  std::size_t doubted = 0;
  for_each_in_order(is_crease.size(), execution, [&](std::size_t v) { doubted += is_crease[v] && is_doubted(v); });
  if (doubted == 0) return;
  std::vector<std::array<double, 2>> counts;
  resize_in_steps(counts, is_crease.size(), execution);
  for_each_index(counts.size(), execution, [&](std::size_t v) { counts[v] = {double(is_crease[v]), 1}; });
  KernelSum(surface.positions(), pool_cell, execution).splat_and_slice(counts, execution);
  for_each_index(counts.size(), execution, [&](std::size_t v) {
    const double share = counts[v][0] / counts[v][1];
    if (is_doubted(v) && (share < least_share || share > largest_share)) is_crease[v] = 0;
  });
}

/// Along the edges from the vertices in `is_start`, as far as `limit`.
std::vector<float> distances(const Surface& surface, const std::vector<char>& is_start, double limit,
                             Execution& execution)
{
  using Reached = std::pair<float, std::uint32_t>;
  std::vector<float> distance(is_start.size(), INFINITY);
  std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> next;
  for_each_in_order(is_start.size(), execution, [&](std::size_t v) {
    if (is_start[v]) next.push({distance[v] = 0, std::uint32_t(v)});
  });
  constexpr std::size_t check_interval = 65536;
  for (std::size_t popped = 1; !next.empty(); ++popped) {
    if (popped % check_interval == 0) execution.check();
    const auto [d, v] = next.top();
    next.pop();
    if (d > distance[v]) continue;
    for (std::uint32_t e = surface.neighbour_start()[v]; e < surface.neighbour_start()[v + 1]; ++e) {
      const std::uint32_t w = surface.neighbours()[e];
      const float farther = d + float(norm(surface.positions()[w] - surface.positions()[v]));
      if (farther < distance[w] && farther < limit) next.push({distance[w] = farther, w});
    }
  }
  return distance;
}

}  // namespace

Creases find_creases(const Surface& surface, const TensorField& tensors, const std::vector<Jet>& fits,
                     const NoiseLevel& noise, const std::vector<char>& is_smooth, Execution& execution)
{
  constexpr double smallest_radius = 2, largest_radius = 4;  // smaller balls see few triangles
  const std::vector<double>& radii = tensors.radii();
  std::size_t scale = 0;
  while (scale < radii.size() && radii[scale] < smallest_radius) ++scale;
  if (scale + 1 >= radii.size() || radii[scale] > largest_radius) return {};

  Creases creases;
  creases.scale = int(scale);
  creases.is_crease.assign(surface.vertex_count(), 0);
  for_each_index(creases.is_crease.size(), execution, [&](std::size_t v) {
    creases.is_crease[v] =
        (is_smooth.empty() || !is_smooth[v]) && is_fold(v, int(scale), tensors, noise) && !is_polynomial(fits[v]);
  });
  if (has_any(creases.is_crease)) keep_lines(surface, noise, radii[scale], creases.is_crease, execution);
  if (!has_any(creases.is_crease)) return {};
  creases.distance = distances(surface, creases.is_crease, radii.back(), execution);
  return creases;
}

}  // namespace integral_invariant
