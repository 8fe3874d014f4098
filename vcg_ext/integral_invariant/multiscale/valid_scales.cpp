// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: whole balls. In: tensors and confidences of all scales. Out: origin of each tensor, largest scale of
// each vertex.
// Cost: 0.1 µs a tensor, and that of the discs. Source: docs/method.md §8.
#include "integral_invariant/multiscale/valid_scales.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/ball_curvature/tangent_frame.h"
#include "integral_invariant/jets/jet_fit.h"
#include "integral_invariant/multiscale/creases.h"
#include "integral_invariant/multiscale/jet_fallback.h"

namespace integral_invariant {

namespace {

/// A ball that is cut by one sheet reads no more than about 2/r, whatever the sheet's shape: more is another sheet,
/// which larger balls meet as well. So is an offset beyond the noise's and that of a curved sheet. Balls that are small
/// against the noise read anything, and are bounded.
void find_own_balls(std::size_t v, const float* offsets, double sigma, TensorField& tensors, ValidScales& balls)
{
  // Below least_kr there is room for the errors of the engine.
  constexpr double least_kr = 0.3, largest_bent_kr = 1.3, largest_kr = 2;
  constexpr double offset_deviations = 4, second_order = 4, offset_share = 0.1;
  const std::vector<double>& radii = tensors.radii();
  std::size_t sheet = radii.size();  // the first scale that meets one
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const CurvatureTensor t = tensors.at_scale(v, int(i));
    const double kr = largest_absolute_curvature(t) * radii[i];
    if (kr > largest_kr) {
      tensors.set(v, int(i), {t.k * (largest_kr / kr), t.normal, t.confidence});
      if (radii[i] > least_radius_over_sigma * sigma) sheet = std::min(sheet, i);
    }
    const double of_noise = offset_deviations * sigma * (1 + second_order * sigma * sigma);
    const double bent = std::clamp(kr, least_kr, largest_bent_kr);
    const double of_shape = offset_share * bent * std::max(1.0, bent * bent) * radii[i];
    if (std::abs(double(offsets[i])) > of_noise + of_shape) sheet = std::min(sheet, i);
    if (t.confidence >= least_confidence && sheet == radii.size()) balls.source[v * radii.size() + i] = Source::ball;
  }
  // It shows late: it may be nearer by this factor, and cut what lies between unseen.
  constexpr double unseen_share = 2.3;
  for (std::size_t i = 0; i < sheet && sheet < radii.size(); ++i) {
    Source& source = balls.source[v * radii.size() + i];
    if (source == Source::ball && radii[sheet] < unseen_share * radii[i]) source = Source::suspect;
  }
}

/// A ball that reaches over a crease gives way to a fit to its own side of it.
void give_up_creased_balls(const Creases& creases, const std::vector<double>& radii, ValidScales& balls,
                           Execution& execution)
{
  constexpr double slack = 0.3;  // distances run along edges, and the least of a ball is at its rim
  for_each_index(creases.distance.size(), execution, [&](std::size_t v) {
    if (creases.is_crease[v]) return;
    for (std::size_t i = 1; i < radii.size(); ++i)
      if (radii[i] > double(creases.distance[v]) + slack) balls.source[v * radii.size() + i] = Source::none;
  });
}

/// On a crease every scale says something else, 1/r: the smallest that noise leaves speaks for it, and nothing of it
/// enters the averages over the neighbourhood. Not where the ball sees another sheet and discs have been fitted.
void keep_one_scale_on_creases(const Creases& creases, const std::vector<double>& radii, const NoiseLevel& noise,
                               ValidScales& balls, Execution& execution)
{
  const std::size_t scales = radii.size();
  for_each_index(creases.is_crease.size(), execution, [&](std::size_t v) {
    const auto source = balls.source.begin() + std::ptrdiff_t(v * scales);
    const auto end = source + std::ptrdiff_t(scales);
    const bool is_fitted = source[creases.scale] != Source::ball && std::find(source, end, Source::jet) != end;
    if (!creases.is_crease[v] || is_fitted) return;
    const double least_radius = least_radius_over_sigma * noise.sigma[v];
    int sharpest = 0;
    while (sharpest < creases.scale && radii[std::size_t(sharpest)] < least_radius) ++sharpest;
    balls.largest[v] = sharpest;
    std::fill(source, end, Source::none);
    source[sharpest] = Source::ball;
  });
}

int largest_scale(std::size_t v, const TensorField& tensors, const NoiseLevel& noise, const ValidScales& balls)
{
  constexpr double least_cosine = 0.7, unchecked_radius = 2.5;
  const std::vector<double>& radii = tensors.radii();
  int largest = 0;
  bool has_normal = false;
  Vec3 normal;
  for (int i = 0; i < int(radii.size()); ++i) {
    const std::size_t place = v * radii.size() + std::size_t(i);
    if (balls.source[place] == Source::none) continue;
    const CurvatureTensor t = tensors.at_scale(v, i);
    // The smallest balls see the noise of a few triangles, which says nothing about larger ones.
    const ThreeSigma doubt = balls.source[place] == Source::jet
                                 ? three_sigma_of(balls.variance(v, std::size_t(i)),
                                                  noise.sigma[v] * std::sqrt(noise.transfer.curvature_ratio(radii[i])))
                                 : ThreeSigma{};
    const bool is_checked = radii[i] > unchecked_radius;
    if (is_checked && has_normal &&
        (exceeds_graph_limit(t, radii[i], doubt) || dot(t.normal, normal) + doubt.normal < least_cosine))
      break;
    largest = i;
    if (!is_checked && balls.source[place] == Source::jet) continue;
    normal = t.normal;
    has_normal = true;
  }
  return largest;
}

}  // namespace

Symmetric3 DiscVariance::covariance_along(const Vec3& u, const Vec3& tensor_normal) const
{
  const Vec3 x = axis(tensor_normal), y = cross(tensor_normal, x);
  return rotate_covariance({curvature[0], curvature[1], curvature[2], curvature[3], curvature[4], curvature[5]},
                           dot(u, x), dot(u, y));
}

ValidScales find_valid_scales(const Surface& surface, const std::vector<float>& offsets, const std::vector<Jet>& fits,
                              const NoiseLevel& noise, bool removes_bias, TensorField& tensors, Execution& execution)
{
  const std::size_t n = surface.vertex_count(), scales = tensors.radii().size();
  ValidScales balls;
  resize_in_steps(balls.source, n * scales, execution);  // none
  resize_in_steps(balls.largest, n, execution);
  parallel_for(
      n, 2048, execution,
      [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t v = begin; v < end; ++v)
          find_own_balls(v, &offsets[v * scales], noise.sigma[v], tensors, balls);
      },
      0.1, 0.12);
  // Those that the fits had are gone: they would stand in the peak of memory, and closed, smooth meshes need none here.
  std::vector<Vec3> normals;
  if (std::any_of(balls.source.begin(), balls.source.end(), [](Source source) { return source != Source::ball; }))
    normals = patch_normals(surface, execution);
  const std::vector<char> is_smooth =
      find_single_sheets(surface, normals, noise, removes_bias, tensors, balls, execution);
  const Creases creases = find_creases(surface, tensors, fits, noise, is_smooth, execution);
  give_up_creased_balls(creases, tensors.radii(), balls, execution);
  if (normals.empty() && !creases.is_crease.empty()) normals = patch_normals(surface, execution);
  fall_back_to_jets(surface, normals, noise, creases, removes_bias, tensors, balls, execution);
  parallel_for(
      n, 2048, execution,
      [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t v = begin; v < end; ++v) balls.largest[v] = largest_scale(v, tensors, noise, balls);
      },
      0.15, 0.2);
  keep_one_scale_on_creases(creases, tensors.radii(), noise, balls, execution);
  return balls;
}

}  // namespace integral_invariant
