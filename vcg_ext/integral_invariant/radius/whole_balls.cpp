// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: whole balls. In: tensors and confidences of all scales. Out: origin of each tensor, largest scale of each vertex.
// Cost: 0.1 µs a tensor; 5 µs for each scale at which any ball is cut. Source: docs/accuracy.md.
#include "integral_invariant/radius/whole_balls.h"

#include "integral_invariant/support/grid_pool.h"

namespace integral_invariant {

namespace {

constexpr double least_confidence = 0.95;

/// Averages of whole balls around a vertex: weight, K (6), n − K p (3).
using Row = std::array<double, 10>;

Row row_of(const CurvatureTensor& t, const Vec3& place)
{
  const Symmetric3& k = t.k;
  const Vec3 normal_at_origin = t.normal - k * place;
  return {1, k.xx, k.xy, k.xz, k.yy, k.yz, k.zz, normal_at_origin.x, normal_at_origin.y, normal_at_origin.z};
}

CurvatureTensor carried_to(const Vec3& place, const Row& sums, const Vec3& fallback)
{
  const double w = 1 / sums[0];
  const Symmetric3 k{sums[1] * w, sums[2] * w, sums[3] * w, sums[4] * w, sums[5] * w, sums[6] * w};
  const Vec3 n = normalized(Vec3{sums[7] * w, sums[8] * w, sums[9] * w} + k * place, fallback);
  return {tangential_part(k, n), n, least_confidence};
}

void fill_scale(const Surface& surface, int scale, TensorField& tensors, WholeBalls& balls)
{
  const std::size_t n = surface.vertex_count(), scales = tensors.radii().size();
  std::vector<Row> rows(n, Row{});
  bool is_complete = true;
  for (std::size_t v = 0; v < n; ++v) {
    if (!surface.is_referenced(v)) continue;
    if (balls.origin[v * scales + scale] == Origin::own)
      rows[v] = row_of(tensors.at_scale(v, scale), surface.positions()[v]);
    else
      is_complete = false;
  }
  if (is_complete) return;

  constexpr double least_weight = 0.05;  // of one whole ball at the very place
  const auto sums = GridPool(surface.positions(), tensors.radii()[scale]).sums(rows);
  for (std::size_t v = 0; v < n; ++v) {
    Origin& origin = balls.origin[v * scales + scale];
    if (origin == Origin::own || sums[v][0] < least_weight) continue;
    origin = Origin::neighbours;
    tensors.set(v, scale, carried_to(surface.positions()[v], sums[v], tensors.at_scale(v, scale).normal));
  }
}

/// A ball that is cut by one sheet reads no more than about 2/r, whatever the sheet's shape: more is another sheet.
void bound_curvature(std::size_t v, TensorField& tensors)
{
  constexpr double largest_kr = 2;
  for (int i = 0; i < int(tensors.radii().size()); ++i) {
    const CurvatureTensor t = tensors.at_scale(v, i);
    const double kr = largest_absolute_curvature(t) * tensors.radii()[std::size_t(i)];
    if (kr > largest_kr) tensors.set(v, i, {t.k * (largest_kr / kr), t.normal, t.confidence});
  }
}

int largest_scale(std::size_t v, const TensorField& tensors, const WholeBalls& balls)
{
  constexpr double largest_kr = 1.3, least_cosine = 0.7, unchecked_radius = 2.5;
  const std::vector<double>& radii = tensors.radii();
  int largest = 0;
  Vec3 normal = tensors.at_scale(v, 0).normal;
  for (int i = 0; i < int(radii.size()); ++i) {
    if (balls.origin[v * radii.size() + i] == Origin::none) continue;
    const CurvatureTensor t = tensors.at_scale(v, i);
    // The smallest balls see the noise of a few triangles, which says nothing about larger ones.
    if (radii[i] > unchecked_radius &&
        (largest_absolute_curvature(t) * radii[i] > largest_kr || dot(t.normal, normal) < least_cosine))
      break;
    largest = i;
    normal = t.normal;
  }
  return largest;
}

}  // namespace

WholeBalls find_whole_balls(const Surface& surface, TensorField& tensors, Execution& execution)
{
  const std::size_t n = surface.vertex_count(), scales = tensors.radii().size();
  WholeBalls balls;
  balls.origin.assign(n * scales, Origin::none);
  balls.largest.resize(n);
  parallel_for(n, 2048, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t v = begin; v < end; ++v) bound_curvature(v, tensors);
  }, 0.1, 0.15);
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t i = 0; i < scales; ++i)
      if (tensors.at_scale(v, int(i)).confidence >= least_confidence) balls.origin[v * scales + i] = Origin::own;
  for (std::size_t i = 0; i < scales; ++i) fill_scale(surface, int(i), tensors, balls);
  parallel_for(n, 2048, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t v = begin; v < end; ++v) balls.largest[v] = largest_scale(v, tensors, balls);
  }, 0.15, 0.2);
  return balls;
}

}  // namespace integral_invariant
