// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: noise estimate. In: offset-free measures of all scales. Out: offset, σ and noise density of every vertex.
// Cost: O(n), about 2 µs a vertex. Source: docs/method.md §4, docs/accuracy.md.
#include "integral_invariant/radius/noise.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/curvature/offset_free.h"
#include "integral_invariant/support/grid_pool.h"

namespace integral_invariant {

namespace {

/// The two scales that offsets are extrapolated from: as small as the triangulation allows.
struct OffsetScales {
  int first;
  double first_weight, second_weight;  ///< sum 1, orthogonal to r⁴
  double own_share;                    ///< variance of δ̂ over σ² is 1 − own_share · (area a vertex)
};

OffsetScales offset_scales(const std::vector<double>& radii)
{
  constexpr double smallest_radius = 2;  // in a smaller ball the triangles' own flatness counts
  const int last = int(radii.size()) - 2;
  OffsetScales s{0, 0, 0, 0};
  while (s.first < last && radii[s.first] < smallest_radius) ++s.first;
  const double a = radii[s.first], b = radii[s.first + 1], q = std::pow(b / a, 4);
  s.first_weight = q / (q - 1);
  s.second_weight = -1 / (q - 1);
  // The fit's kernel at the centre is 4/(π r²), which is its norm too, and the product of two nested ones is the larger's.
  const double ka = disc_variance::height / (a * a), kb = disc_variance::height / (b * b);
  const double own = s.first_weight * ka + s.second_weight * kb;
  const double squares = s.first_weight * s.first_weight * ka +
                         (2 * s.first_weight * s.second_weight + s.second_weight * s.second_weight) * kb;
  s.own_share = 2 * own - squares;
  return s;
}

/// Areas of the vertices, a third of their triangles', projected along the normals of small balls: noise inflates the
/// triangles' own areas.
std::vector<double> projected_areas(const Surface& surface, const TensorField& tensors, int scale)
{
  std::vector<double> area(surface.vertex_count(), 0);
  const std::vector<Vec3>& p = surface.positions();
  for (const Triangle& t : surface.triangles()) {
    const Vec3 doubled = cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
    for (const int v : t) area[v] += dot(doubled, tensors.at_scale(v, scale).normal) / 6;
  }
  for (double& a : area) a = std::max(a, 0.0);
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

/// How much a vertex's small balls show noise and not a crease or a boundary. It falls gently with the curvature: a small
/// part may have nothing better, and a threshold would pick vertices by their noise.
double smoothness(const CurvatureTensor& tensor, double radius)
{
  constexpr double usual_kr = 0.6, largest_kr = 1.2, least_confidence = 0.95;
  const double kr = largest_absolute_curvature(tensor) * radius;
  return tensor.confidence < least_confidence || kr > largest_kr ? 0 : 1 / (1 + std::pow(kr / usual_kr, 6));
}

/// Largest offset that is taken for noise: six robust standard deviations over the whole mesh. Beyond are creases and thin
/// parts, whose offsets are shape.
double largest_noise(std::vector<double> offsets)
{
  constexpr double deviations = 6, normal_mad = 1.4826, least = 0.005;
  if (offsets.empty()) return least;
  for (double& offset : offsets) offset = std::abs(offset);
  const auto middle = offsets.begin() + std::ptrdiff_t(offsets.size() / 2);
  std::nth_element(offsets.begin(), middle, offsets.end());
  return std::max(least, deviations * normal_mad * *middle);
}

}  // namespace

Noise estimate_noise(const Surface& surface, const TensorField& tensors, const std::vector<float>& offsets,
                     double known_sigma, Execution&)
{
  const std::size_t n = surface.vertex_count(), scales = tensors.radii().size();
  const OffsetScales s = offset_scales(tensors.radii());
  const int calm = std::min(s.first + 2, int(scales) - 1);  // a larger ball, whose curvature is less noisy
  const std::vector<double> area = projected_areas(surface, tensors, calm);
  constexpr double usual_area = 0.87, pool_cell = 8;
  // Measured on a sphere: the curvature of its triangulation is off by 0.11 e⁴/r⁴, e the edge length.
  constexpr double flatness_error = 0.11;

  Noise noise;
  noise.offset.resize(n);
  noise.flatness.resize(n);
  std::vector<double> uneven(n);  // how much triangles differ in how far they lie inside
  std::vector<std::array<double, 4>> local(n);
  std::vector<double> found;
  for (std::size_t v = 0; v < n; ++v) {
    const double counts = surface.is_referenced(v) ? smoothness(tensors.at_scale(v, calm), tensors.radii()[calm]) : 0;
    const CurvatureTensor small = tensors.at_scale(v, s.first + 1);
    const SquaredEdges edges = squared_edges(surface, v, small.normal);
    const double mean = small.k.trace() / 2;
    noise.flatness[v] = flatness_error * std::abs(mean) * edges.mean * edges.mean;
    uneven[v] = mean * edges.deviation / 8;
    // Triangles lie inside a smooth surface, on average by H times a 24th of a triangle's squared edges.
    const double offset = s.first_weight * offsets[v * scales + s.first] +
                          s.second_weight * offsets[v * scales + s.first + 1] + mean * edges.mean / 8;
    noise.offset[v] = counts > 0 ? offset : 0;
    if (counts > 0) found.push_back(offset);
    local[v] = {counts, counts, counts * area[v], counts * area[v] * area[v]};
  }
  const double largest = largest_noise(std::move(found));
  for (std::size_t v = 0; v < n; ++v) local[v][1] *= std::pow(std::min(std::abs(noise.offset[v]), largest), 2);
  const auto pooled = GridPool(surface.positions(), pool_cell).sums(local);

  // Vertices without a smooth neighbourhood get the average of the others.
  double variance_sum = 0, count = 0;
  std::vector<double> variance(n, -1), area_each(n, usual_area);
  for (std::size_t v = 0; v < n; ++v) {
    if (!(pooled[v][0] > 1e-3) || !(pooled[v][2] > 0)) continue;
    const double own = s.own_share * pooled[v][2] / pooled[v][0];
    variance[v] = pooled[v][1] / pooled[v][0] / std::max(0.3, 1 - own);
    area_each[v] = pooled[v][3] / pooled[v][2];
    variance_sum += variance[v];
    ++count;
  }
  const double usual_variance = count > 0 ? variance_sum / count : 0;
  noise.sigma.resize(n);
  noise.density.resize(n);
  for (std::size_t v = 0; v < n; ++v) {
    const double own = variance[v] >= 0 ? variance[v] : usual_variance;
    noise.sigma[v] = known_sigma > 0 ? known_sigma : std::sqrt(own);
    noise.density[v] = area_each[v] * (noise.sigma[v] * noise.sigma[v] + uneven[v] * uneven[v]);
  }
  noise.mean_sigma = known_sigma > 0 ? known_sigma : std::sqrt(usual_variance);
  return noise;
}

}  // namespace integral_invariant
