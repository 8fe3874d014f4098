// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: noise estimate. In: offset-free measures of all scales, fits to the vertices. Out: offset, σ and noise
// density of every vertex.
// Cost: O(n), about 2 µs a vertex. Source: docs/method.md §7.
#include "integral_invariant/multiscale/noise_level.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "integral_invariant/support/kernel_sum.h"

namespace integral_invariant {

namespace {

/// The two scales that offsets are extrapolated from: as small as the triangulation allows.
struct OffsetScales {
  int first;
  double first_weight, second_weight;  ///< sum 1, orthogonal to r⁴
};

OffsetScales offset_scales(const std::vector<double>& radii)
{
  constexpr double smallest_radius = 2;  // in a smaller ball the triangles' own flatness counts
  const int last = int(radii.size()) - 2;
  OffsetScales s{0, 0, 0};
  while (s.first < last && radii[s.first] < smallest_radius) ++s.first;
  const double a = radii[s.first], b = radii[s.first + 1], q = std::pow(b / a, 4);
  s.first_weight = q / (q - 1);
  s.second_weight = -1 / (q - 1);
  return s;
}

/// Areas of the vertices, a third of their triangles', projected along the normals of small balls: noise inflates the
/// triangles' own areas.
std::vector<double> projected_areas(const Surface& surface, const TensorField& tensors, int scale, Execution& execution)
{
  std::vector<double> area;
  resize_in_steps(area, surface.vertex_count(), execution);
  const std::vector<Vec3>& p = surface.positions();
  for_each_in_order(surface.triangles().size(), execution, [&](std::size_t i) {
    const Triangle& t = surface.triangles()[i];
    const Vec3 doubled = cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
    for (const int v : t) area[v] += dot(doubled, tensors.at_scale(v, scale).normal) / 6;
  });
  for_each_index(area.size(), execution, [&](std::size_t v) { area[v] = std::max(area[v], 0.0); });
  return area;
}

/// Squared lengths of the edges at v, projected along the normal.
struct SquaredEdges {
  double mean = 0, deviation = 0;
};

SquaredEdges squared_edges(const Surface& surface, std::size_t v, const Vec3& normal)
{
  double sum = 0, squares = 0;
  const std::uint32_t begin = surface.neighbour_start()[v], end = surface.neighbour_start()[v + 1];
  if (begin == end) return {};
  for (std::uint32_t i = begin; i < end; ++i) {
    const Vec3 edge = surface.positions()[surface.neighbours()[i]] - surface.positions()[v];
    const double height = dot(edge, normal), squared = squared_norm(edge) - height * height;
    sum += squared;
    squares += squared * squared;
  }
  const double mean = sum / double(end - begin);
  return {mean, std::sqrt(std::max(0.0, squares / double(end - begin) - mean * mean))};
}

/// How much a vertex's small balls show noise and not a crease or a boundary. It falls gently with the curvature: a
/// small part may have nothing better.
double smoothness(const CurvatureTensor& tensor, double radius)
{
  constexpr double usual_kr = 0.6, largest_kr = 1.2, least_confidence = 0.95;
  const double kr = largest_absolute_curvature(tensor) * radius;
  return tensor.confidence < least_confidence || kr > largest_kr ? 0 : 1 / (1 + std::pow(kr / usual_kr, 6));
}

/// What the fits of a neighbourhood leave over.
struct Residuals {
  std::vector<double> variance;     ///< or −1 where there is none
  std::vector<double> lack_of_fit;  ///< of it
};

/// Of what a neighbourhood's polynomials leave over. Noise stands in their terms of the highest degree as much as in
/// what is beyond them; shape falls from degree to degree.
double lack_of_fit_of(double top_degree_variance, double residual)
{
  constexpr double of_noise = 1.5, of_shape = 4;  // measured: 0.8 to 1.2 with noise, 40 and more without
  return residual > 0 ? std::clamp((top_degree_variance / residual - of_noise) / (of_shape - of_noise), 0.0, 1.0) : 1;
}

/// Creases stand out of the neighbourhood: first the average of the logarithms, which they move little, then of those
/// that agree with it.
Residuals pooled_residuals(const std::vector<Jet>& fits, const KernelSum& pool, Execution& execution)
{
  constexpr double least = 1e-20, evident = 6;
  // Single fillets and creases do not speak for the flat parts beside them.
  constexpr double largest_top = 8;
  constexpr int rounds = 4;
  const std::size_t n = fits.size();
  Residuals result;
  resize_in_steps(result.variance, n, execution, -1.0);
  resize_in_steps(result.lack_of_fit, n, execution);
  std::vector<double>& variance = result.variance;
  std::vector<std::array<double, 3>> local;
  resize_in_steps(local, n, execution);
  const auto counts = [&](std::size_t v) { return fits[v].residual_variance >= 0; };
  for_each_index(n, execution, [&](std::size_t v) {
    local[v] = {counts(v) ? 1.0 : 0, counts(v) ? std::log(fits[v].residual_variance + least) : 0, 0};
  });
  pool.splat_and_slice(local, execution);
  for_each_index(n, execution, [&](std::size_t v) {
    if (local[v][0] > 1e-3) variance[v] = std::exp(local[v][1] / local[v][0]);
  });
  for (int round = 0; round < rounds; ++round) {
    for_each_index(n, execution, [&](std::size_t v) {
      const bool agrees = counts(v) && fits[v].residual_variance < evident * variance[v];
      local[v] = {agrees ? 1.0 : 0, agrees ? fits[v].residual_variance : 0,
                  agrees ? std::clamp(fits[v].top_degree_variance, 0.0, largest_top * variance[v]) : 0};
    });
    pool.splat_and_slice(local, execution);
    for_each_index(n, execution, [&](std::size_t v) {
      if (local[v][0] > 1e-3) variance[v] = local[v][1] / local[v][0];
    });
  }
  for_each_index(n, execution, [&](std::size_t v) {
    if (local[v][0] > 1e-3) result.lack_of_fit[v] = lack_of_fit_of(local[v][2], local[v][1]);
  });
  return result;
}

}  // namespace

NoiseLevel estimate_noise_level(const Surface& surface, const TensorField& tensors, const std::vector<float>& offsets,
                                const std::vector<Jet>& fits, double known_sigma, Execution& execution)
{
  const std::size_t n = surface.vertex_count(), scales = tensors.radii().size();
  const OffsetScales s = offset_scales(tensors.radii());
  const int calm = std::min(s.first + 2, int(scales) - 1);  // a larger ball, whose curvature is less noisy
  const std::vector<double> area = projected_areas(surface, tensors, calm, execution);
  constexpr double pool_cell = 8;

  NoiseLevel noise;
  std::vector<double> uneven;  // how much triangles differ in how far they lie inside
  std::vector<std::array<double, 2>> local;
  for (std::vector<double>* values : {&noise.offset, &noise.faceting_error, &noise.sigma, &noise.density, &uneven})
    resize_in_steps(*values, n, execution);
  resize_in_steps(noise.defies_jets, n, execution);
  resize_in_steps(local, n, execution);
  for_each_index(n, execution, [&](std::size_t v) {
    const double counts = surface.is_referenced(v) ? smoothness(tensors.at_scale(v, calm), tensors.radii()[calm]) : 0;
    const CurvatureTensor small = tensors.at_scale(v, s.first + 1);
    const SquaredEdges edges = squared_edges(surface, v, small.normal);
    const double mean = small.k.trace() / 2;
    noise.faceting_error[v] = flatness_error * std::abs(mean) * edges.mean * edges.mean;
    uneven[v] = mean * edges.deviation / 8;
    // Triangles lie inside a smooth surface, on average by H times a 24th of a triangle's squared edges.
    const double offset = s.first_weight * offsets[v * scales + s.first] +
                          s.second_weight * offsets[v * scales + s.first + 1] + mean * edges.mean / 8;
    noise.offset[v] = counts > 0 ? offset : 0;
    local[v] = {counts * area[v], counts * area[v] * area[v]};
  });
  const KernelSum pool(surface.positions(), pool_cell, execution);
  pool.splat_and_slice(local, execution);
  Residuals residuals = pooled_residuals(fits, pool, execution);
  const std::vector<double>& variance = residuals.variance;
  noise.lack_of_fit = std::move(residuals.lack_of_fit);
  if (known_sigma > 0) noise.lack_of_fit.assign(n, 0);

  // Vertices without fits around get the average of the others.
  double variance_sum = 0, count = 0;
  std::vector<double> area_each;
  resize_in_steps(area_each, n, execution, usual_area);
  for_each_in_order(n, execution, [&](std::size_t v) {
    if (local[v][0] > 0) area_each[v] = local[v][1] / local[v][0];
    if (variance[v] < 0) return;
    variance_sum += variance[v];
    ++count;
  });
  const double usual_variance = count > 0 ? variance_sum / count : 0;
  for_each_index(n, execution, [&](std::size_t v) {
    const double own = variance[v] >= 0 ? variance[v] : usual_variance;
    noise.sigma[v] = known_sigma > 0 ? known_sigma : std::sqrt(own);
    noise.density[v] = area_each[v] * (noise.sigma[v] * noise.sigma[v] + uneven[v] * uneven[v]);
  });
  noise.mean_sigma = known_sigma > 0 ? known_sigma : std::sqrt(usual_variance);
  return noise;
}

}  // namespace integral_invariant
