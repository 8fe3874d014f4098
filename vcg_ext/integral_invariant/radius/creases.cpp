// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: creases. In: tensors of two small scales, noise. Out: crease vertices, distance of all others to them.
// Cost: O(n), and O(n log n) where there are creases. Source: Dijkstra's method; docs/accuracy.md.
#include "integral_invariant/radius/creases.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>

#include "integral_invariant/curvature/offset_free.h"
#include "integral_invariant/radius/whole_balls.h"

namespace integral_invariant {

namespace {

bool is_fold(std::size_t v, int scale, const TensorField& tensors, const Noise& noise)
{
  constexpr double least_kr = 0.5, least_fall = 1.3, deviations = 3;
  const CurvatureTensor small = tensors.at_scale(v, scale), large = tensors.at_scale(v, scale + 1);
  if (small.confidence < least_confidence || large.confidence < least_confidence) return false;
  const double r = tensors.radii()[std::size_t(scale)];
  if (r < least_radius_over_sigma * noise.sigma[v]) return false;
  const double k = largest_absolute_curvature(small);
  const double deviation =
      std::sqrt((disc_variance::mean_curvature + disc_variance::deviator) * noise.density[v]) / (r * r * r);
  return (k - deviations * deviation) * r > least_kr && k > least_fall * largest_absolute_curvature(large);
}

bool is_polynomial(const VertexFit& fit)
{
  constexpr double largest_residual = 0.02, largest_kr = 1.3;
  return fit.tensor.confidence > 0 && fit.residual >= 0 && fit.residual < largest_residual * largest_residual &&
         largest_absolute_curvature(fit.tensor) * fit.reach < largest_kr;
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

Creases find_creases(const Surface& surface, const TensorField& tensors, const std::vector<VertexFit>& fits,
                     const Noise& noise, const std::vector<char>& is_smooth, Execution& execution)
{
  // Smaller balls see few triangles; in larger ones smooth parts of the same size look the same.
  constexpr double smallest_radius = 2, largest_radius = 4;
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
  if (std::find(creases.is_crease.begin(), creases.is_crease.end(), 1) == creases.is_crease.end()) return {};
  creases.distance = distances(surface, creases.is_crease, radii.back(), execution);
  return creases;
}

}  // namespace integral_invariant
