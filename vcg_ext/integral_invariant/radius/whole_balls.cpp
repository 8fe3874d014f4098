// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: whole balls. In: tensors and confidences of all scales. Out: origin of each tensor, largest scale of
// each vertex.
// Cost: 0.1 µs a tensor; 50 µs a vertex whose largest balls are cut. Source: docs/accuracy.md.
#include "integral_invariant/radius/whole_balls.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/curvature/bias.h"
#include "integral_invariant/curvature/vertex_fit.h"
#include "integral_invariant/radius/creases.h"

namespace integral_invariant {

namespace {

constexpr double least_confidence = 0.95;

bool has_cut_ball(std::size_t v, const Surface& surface, const WholeBalls& balls, std::size_t scales)
{
  if (!surface.is_referenced(v)) return false;
  for (std::size_t i = 0; i < scales; ++i)
    if (balls.origin[v * scales + i] == Origin::none) return true;
  return false;
}

/// Points along a line leave a fit free across it, with a variance that single precision does not hold.
bool is_usable(const VertexFit& fit)
{
  constexpr double largest_variance = 1e12;
  return fit.tensor.confidence > 0 && fit.mean_variance <= largest_variance &&
         fit.deviator_variance <= largest_variance && fit.normal_variance <= largest_variance;
}

/// Noise, and what a smooth surface has beyond the second degree: on a surface with creases, more is one that runs
/// through the disc.
bool fits_well(const VertexFit& fit, double sigma)
{
  constexpr double deviations = 2, shape_share = 0.04;
  return std::sqrt(fit.residual) <= deviations * sigma + shape_share * fit.reach;
}

/// Three standard deviations of what a fit to vertices says: its curvature, its normal.
struct Doubt {
  double curvature = 0, normal = 0;
};

Doubt doubt_of(std::size_t place, double sigma, const WholeBalls& balls)
{
  if (balls.origin[place] != Origin::vertices) return {};
  const std::array<float, 3>& variance = balls.variance[place];
  return {3 * sigma * std::sqrt(double(variance[0]) + double(variance[1])),
          3 * sigma * std::sqrt(2 * double(variance[2]))};
}

/// Larger balls and discs say nothing: the surface turns away within this one.
bool is_bent(const CurvatureTensor& tensor, double radius, const Doubt& doubt)
{
  constexpr double largest_kr = 1.3;
  return (largest_absolute_curvature(tensor) - doubt.curvature) * radius > largest_kr;
}

void fill_from_vertices(std::size_t v, Vec3 normal, double sigma, const Creases& creases, VertexFitter& fitter,
                        bool removes_bias, TensorField& tensors, WholeBalls& balls)
{
  constexpr std::size_t usual_scale = 3;
  constexpr double least_fit_radius = 2.5, largest_lean = 0.2;
  const std::vector<double>& radii = tensors.radii();
  const std::size_t usual = std::min(usual_scale, radii.size() - 1);
  fitter.start_disc(v, normal);
  const VertexFit rough = fitter.grow_disc(radii[usual]);
  if (rough.tensor.confidence > 0) normal = rough.tensor.normal;
  fitter.start_disc(v, normal);
  const bool has_creases = !creases.is_crease.empty(), is_crease = has_creases && creases.is_crease[v];
  bool has_any = balls.origin[v * radii.size()] == Origin::own;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const std::size_t place = v * radii.size() + i;
    // Half a disc of two rows of vertices leaves a quadric all but free.
    if (balls.origin[place] == Origin::own || radii[i] < least_fit_radius) continue;
    const VertexFit fit = fitter.grow_disc(radii[i]);
    if (!is_usable(fit) || (is_crease && fit.lean > largest_lean)) continue;
    if (has_creases && !fits_well(fit, sigma)) break;
    const CurvatureTensor t = removes_bias ? without_graph_bias(fit.tensor, radii[i]) : fit.tensor;
    tensors.set(v, int(i), {t.k, t.normal, least_confidence});
    balls.origin[place] = Origin::vertices;
    balls.variance[place] = {float(fit.mean_variance), float(fit.deviator_variance), float(fit.normal_variance)};
    if (has_any && is_bent(t, radii[i], doubt_of(place, sigma, balls))) break;
    has_any = true;
  }
  if (has_any || is_crease) return;
  // Where all discs are too small or turn away, there are the nearest vertices.
  const VertexFit nearest = fitter.nearest(v, normal);
  if (!is_usable(nearest)) return;
  tensors.set(v, 0, {nearest.tensor.k, nearest.tensor.normal, least_confidence});
  balls.origin[v * radii.size()] = Origin::vertices;
  balls.variance[v * radii.size()] = {float(nearest.mean_variance), float(nearest.deviator_variance),
                                      float(nearest.normal_variance)};
}

void replace_cut_balls(const Surface& surface, const Noise& noise, const Creases& creases, bool removes_bias,
                       TensorField& tensors, WholeBalls& balls, Execution& execution)
{
  const std::size_t n = surface.vertex_count(), scales = tensors.radii().size();
  std::vector<std::uint32_t> cut;
  for_each_in_order(n, execution, [&](std::size_t v) {
    if (has_cut_ball(v, surface, balls, scales)) cut.push_back(std::uint32_t(v));
  });
  if (cut.empty()) return;
  resize_in_steps(balls.variance, n * scales, execution);
  const std::vector<Vec3> normals = patch_normals(surface, execution);
  VertexFitters fitters(surface, execution, creases.is_crease);
  parallel_for(
      cut.size(), 64, execution,
      [&](std::size_t begin, std::size_t end, int worker) {
        VertexFitter& fitter = fitters.of(worker);
        for (std::size_t i = begin; i < end; ++i) {
          const std::uint32_t v = cut[i];
          fill_from_vertices(v, normals[v], noise.sigma[v], creases, fitter, removes_bias, tensors, balls);
        }
      },
      0.15, 0.2);
}

/// A ball that is cut by one sheet reads no more than about 2/r, whatever the sheet's shape: more is another sheet,
/// which larger balls meet as well. So is an offset beyond the noise's and that of a curved sheet. Balls that are small
/// against the noise read anything, and are bounded.
void find_own_balls(std::size_t v, const float* offsets, double sigma, TensorField& tensors, WholeBalls& balls)
{
  // Below least_kr there is room for the errors of the engine.
  constexpr double least_kr = 0.3, largest_bent_kr = 1.3, largest_kr = 2;
  constexpr double offset_deviations = 4, second_order = 4, offset_share = 0.1;
  const std::vector<double>& radii = tensors.radii();
  bool meets_other_sheet = false;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const CurvatureTensor t = tensors.at_scale(v, int(i));
    const double kr = largest_absolute_curvature(t) * radii[i];
    if (kr > largest_kr) {
      tensors.set(v, int(i), {t.k * (largest_kr / kr), t.normal, t.confidence});
      meets_other_sheet = meets_other_sheet || radii[i] > least_radius_over_sigma * sigma;
    }
    const double of_noise = offset_deviations * sigma * (1 + second_order * sigma * sigma);
    const double bent = std::clamp(kr, least_kr, largest_bent_kr);
    const double of_shape = offset_share * bent * std::max(1.0, bent * bent) * radii[i];
    if (std::abs(double(offsets[i])) > of_noise + of_shape) meets_other_sheet = true;
    if (t.confidence >= least_confidence && !meets_other_sheet) balls.origin[v * radii.size() + i] = Origin::own;
  }
}

/// A ball that reaches over a crease gives way to a fit to its own side of it.
void give_up_creased_balls(const Creases& creases, const std::vector<double>& radii, WholeBalls& balls,
                           Execution& execution)
{
  constexpr double slack = 0.3;  // distances run along edges, and the least of a ball is at its rim
  for_each_index(creases.distance.size(), execution, [&](std::size_t v) {
    if (creases.is_crease[v]) return;
    for (std::size_t i = 1; i < radii.size(); ++i)
      if (radii[i] > double(creases.distance[v]) + slack) balls.origin[v * radii.size() + i] = Origin::none;
  });
}

/// On a crease every scale says something else, 1/r: the smallest that noise leaves speaks for it, and nothing of it
/// enters the averages over the neighbourhood. Not where the ball sees another sheet and discs have been fitted.
void keep_one_scale_on_creases(const Creases& creases, const std::vector<double>& radii, const Noise& noise,
                               WholeBalls& balls, Execution& execution)
{
  const std::size_t scales = radii.size();
  for_each_index(creases.is_crease.size(), execution, [&](std::size_t v) {
    const auto origin = balls.origin.begin() + std::ptrdiff_t(v * scales);
    const auto end = origin + std::ptrdiff_t(scales);
    const bool is_fitted = origin[creases.scale] != Origin::own && std::find(origin, end, Origin::vertices) != end;
    if (!creases.is_crease[v] || is_fitted) return;
    const double least_radius = least_radius_over_sigma * noise.sigma[v];
    int sharpest = 0;
    while (sharpest < creases.scale && radii[std::size_t(sharpest)] < least_radius) ++sharpest;
    balls.largest[v] = sharpest;
    std::fill(origin, end, Origin::none);
    origin[sharpest] = Origin::own;
  });
}

int largest_scale(std::size_t v, const TensorField& tensors, double sigma, const WholeBalls& balls)
{
  constexpr double least_cosine = 0.7, unchecked_radius = 2.5;
  const std::vector<double>& radii = tensors.radii();
  int largest = 0;
  bool has_normal = false;
  Vec3 normal;
  for (int i = 0; i < int(radii.size()); ++i) {
    if (balls.origin[v * radii.size() + i] == Origin::none) continue;
    const CurvatureTensor t = tensors.at_scale(v, i);
    // The smallest balls see the noise of a few triangles, which says nothing about larger ones.
    const Doubt doubt = doubt_of(v * radii.size() + i, sigma, balls);
    const bool is_checked = radii[i] > unchecked_radius;
    if (is_checked && has_normal &&
        (is_bent(t, radii[i], doubt) || dot(t.normal, normal) + doubt.normal < least_cosine))
      break;
    largest = i;
    if (!is_checked && balls.origin[v * radii.size() + i] == Origin::vertices) continue;
    normal = t.normal;
    has_normal = true;
  }
  return largest;
}

}  // namespace

WholeBalls find_whole_balls(const Surface& surface, const std::vector<float>& offsets,
                            const std::vector<VertexFit>& fits, const Noise& noise, bool removes_bias,
                            TensorField& tensors, Execution& execution)
{
  const std::size_t n = surface.vertex_count(), scales = tensors.radii().size();
  WholeBalls balls;
  resize_in_steps(balls.origin, n * scales, execution);  // none
  resize_in_steps(balls.largest, n, execution);
  parallel_for(
      n, 2048, execution,
      [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t v = begin; v < end; ++v)
          find_own_balls(v, &offsets[v * scales], noise.sigma[v], tensors, balls);
      },
      0.1, 0.12);
  const Creases creases = find_creases(surface, tensors, fits, noise, execution);
  give_up_creased_balls(creases, tensors.radii(), balls, execution);
  replace_cut_balls(surface, noise, creases, removes_bias, tensors, balls, execution);
  parallel_for(
      n, 2048, execution,
      [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t v = begin; v < end; ++v) balls.largest[v] = largest_scale(v, tensors, noise.sigma[v], balls);
      },
      0.15, 0.2);
  keep_one_scale_on_creases(creases, tensors.radii(), noise, balls, execution);
  return balls;
}

}  // namespace integral_invariant
