// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: discs for balls. In: tensors and the origins that balls of their own leave. Out: the same with tensors from
// vertices. Cost: 15 µs a vertex whose largest balls give way. Source: docs/method.md §8.
#include "integral_invariant/multiscale/jet_fallback.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/ball_curvature/ball_bias.h"
#include "integral_invariant/ball_curvature/offset_free.h"
#include "integral_invariant/jets/jet_fit.h"

namespace integral_invariant {

namespace {

/// Half a disc of two rows of vertices leaves a quadric all but free.
constexpr double least_fit_radius = 2.5;

/// Points along a line leave a fit free across it, with a variance that single precision does not hold.
bool is_usable(const Jet& fit)
{
  constexpr double largest_variance = 1e12;
  return fit.tensor.confidence > 0 && fit.mean_variance <= largest_variance &&
         fit.deviator_variance <= largest_variance && fit.normal_variance <= largest_variance;
}

/// Noise, and what a smooth surface has beyond the second degree: where there are creases or other sheets, more is one
/// that runs through the disc.
bool fits_well(const Jet& fit, double sigma)
{
  constexpr double deviations = 2, shape_share = 0.04;
  return std::sqrt(fit.residual_variance) <= deviations * sigma + shape_share * fit.support_radius;
}

DiscVariance isotropic_variance(const Jet& fit)
{
  const float deviator = float(fit.deviator_variance);
  return {{float(fit.mean_variance), 0, 0, deviator, 0, deviator}, float(fit.normal_variance)};
}

CurvatureTensor tensor_of(const Jet& fit, bool removes_bias)
{
  return removes_bias ? correct_jet_bias(fit.tensor, fit.support_radius) : fit.tensor;
}

/// Balls and discs of one vertex.
class VertexScales {
 public:
  VertexScales(std::size_t v, const NoiseLevel& noise, TensorField& tensors, ValidScales& balls)
      : v_(v),
        sigma_(noise.sigma[v]),
        density_(noise.density[v]),
        transfer_(noise.transfer),
        tensors_(tensors),
        balls_(balls)
  {
  }

  std::size_t vertex() const { return v_; }
  double sigma() const { return sigma_; }
  double sigma_at(double r) const { return sigma_ * std::sqrt(transfer_.curvature_ratio(r)); }
  const std::vector<double>& radii() const { return tensors_.radii(); }
  std::size_t count() const { return radii().size(); }
  Source source(std::size_t scale) const { return balls_.source[place(scale)]; }

  bool has_doubts() const
  {
    for (std::size_t i = 0; i < count(); ++i)
      if (source(i) == Source::suspect) return true;
    return false;
  }
  /// Of the scales before `end`.
  void settle_doubts(std::size_t end, Source verdict)
  {
    for (std::size_t i = 0; i < end; ++i)
      if (source(i) == Source::suspect) balls_.source[place(i)] = verdict;
  }

  /// What the fitter's last disc says.
  void set_disc(std::size_t scale, const Jet& fit, const CurvatureTensor& tensor, const JetFitter& fitter)
  {
    DiscVariance& variance = set_fit(scale, fit, tensor);
    const Symmetric3 c = fitter.disc_covariance(DiscVariance::axis(tensors_.at_scale(v_, int(scale)).normal));
    variance.curvature = {float(c.xx), float(c.xy), float(c.xz), float(c.yy), float(c.yz), float(c.zz)};
  }
  /// Any fit, with the same variance in all directions.
  DiscVariance& set_fit(std::size_t scale, const Jet& fit, const CurvatureTensor& tensor)
  {
    tensors_.set(v_, int(scale), {tensor.k, tensor.normal, tensors_.at_scale(v_, int(scale)).confidence});
    balls_.source[place(scale)] = Source::jet;
    return balls_.variances[balls_.row[v_] * count() + scale] = isotropic_variance(fit);
  }

  /// Whether ball and disc see the same sheet. To first order they are the same estimator, noise included; as the
  /// surface bends they part.
  bool agrees(std::size_t scale, const CurvatureTensor& disc) const
  {
    constexpr double flat_share = 0.1, bent_share = 0.5;
    const double r = radii()[scale], k = largest_absolute_curvature(disc);
    const double deviation =
        std::sqrt(disc_variance::mean_curvature * density_ * transfer_.curvature_ratio(r)) / (r * r * r);
    const double difference = std::abs(tensors_.at_scale(v_, int(scale)).k.trace() - disc.k.trace()) / 2;
    return difference <= deviation + (flat_share + bent_share * k * r * k * r) * k;
  }

 private:
  std::size_t place(std::size_t scale) const { return v_ * count() + scale; }

  const std::size_t v_;
  const double sigma_, density_;
  const NoiseTransfer& transfer_;
  TensorField& tensors_;
  ValidScales& balls_;
};

void substitute_discs_at(VertexScales scales, Vec3 normal, const Creases& creases, bool removes_bias, JetFitter& fitter)
{
  constexpr std::size_t usual_scale = 3;
  constexpr double largest_lean = 0.2;
  const std::vector<double>& radii = scales.radii();
  const std::size_t v = scales.vertex();
  fitter.begin_disc(v, normal);
  const Jet rough = fitter.extend_disc(radii[std::min(usual_scale, radii.size() - 1)]);
  if (rough.tensor.confidence > 0) normal = rough.tensor.normal;
  fitter.begin_disc(v, normal);
  const bool has_creases = !creases.is_crease.empty(), is_crease = has_creases && creases.is_crease[v];
  const bool must_fit = has_creases || scales.has_doubts();
  bool has_any = scales.source(0) == Source::ball;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    if (scales.source(i) == Source::ball || radii[i] < least_fit_radius) continue;
    const Jet fit = fitter.extend_disc(radii[i]);
    if (!is_usable(fit) || (is_crease && fit.centroid_offset > largest_lean)) {
      scales.settle_doubts(radii.size(), Source::ball);
      continue;
    }
    if (must_fit && !fits_well(fit, scales.sigma())) break;
    const CurvatureTensor t = tensor_of(fit, removes_bias);
    const bool bends =
        exceeds_graph_limit(t, radii[i], three_sigma_of(isotropic_variance(fit), scales.sigma_at(radii[i])));
    if (bends && scales.has_doubts()) break;
    const bool agrees = scales.source(i) == Source::suspect && scales.agrees(i, t);
    scales.settle_doubts(i + 1, agrees ? Source::ball : Source::none);
    if (!agrees) scales.set_disc(i, fit, t, fitter);
    if (has_any && bends) break;
    has_any = true;
  }
  // No disc spoke against them.
  scales.settle_doubts(radii.size(), Source::ball);
  if (has_any || is_crease || scales.source(0) == Source::ball) return;
  // Where all discs are too small or turn away, there are the nearest vertices.
  const Jet nearest = fitter.nearest(v, normal);
  if (is_usable(nearest)) scales.set_fit(0, nearest, nearest.tensor);
}

bool has_all_balls(std::size_t v, const ValidScales& balls, std::size_t scales)
{
  const auto begin = balls.source.begin() + std::ptrdiff_t(v * scales), end = begin + std::ptrdiff_t(scales);
  return std::all_of(begin, end, [](Source source) { return source == Source::ball; });
}

}  // namespace

ThreeSigma three_sigma_of(const DiscVariance& variance, double sigma)
{
  return {3 * sigma * std::sqrt(double(variance.mean()) + double(variance.deviator())),
          3 * sigma * std::sqrt(2 * double(variance.normal))};
}

bool exceeds_graph_limit(const CurvatureTensor& tensor, double radius, const ThreeSigma& doubt)
{
  constexpr double largest_kr = 1.3;
  return (largest_absolute_curvature(tensor) - doubt.curvature) * radius > largest_kr;
}

std::vector<char> find_single_sheets(const Surface& surface, const std::vector<Vec3>& normals, const NoiseLevel& noise,
                                     bool removes_bias, const TensorField& tensors, const ValidScales& balls,
                                     Execution& execution)
{
  const std::vector<double>& radii = tensors.radii();
  const std::size_t n = surface.vertex_count();
  const std::size_t scale = std::size_t(std::lower_bound(radii.begin(), radii.end(), least_fit_radius) - radii.begin());
  if (scale == radii.size()) return {};
  std::vector<std::uint32_t> beside_others;
  for_each_in_order(n, execution, [&](std::size_t v) {
    if (surface.is_referenced(v) && balls.source[v * radii.size() + scale] != Source::ball &&
        tensors.at_scale(v, int(scale)).confidence >= least_confidence)
      beside_others.push_back(std::uint32_t(v));
  });
  if (beside_others.empty()) return {};
  std::vector<char> is_smooth;
  resize_in_steps(is_smooth, n, execution);
  JetFitters fitters(surface, execution);
  parallel_step(beside_others.size(), 256, execution, [&](std::size_t begin, std::size_t end, int worker) {
    JetFitter& fitter = fitters.of(worker);
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t v = beside_others[i];
      fitter.begin_disc(v, normals[v]);
      const Jet fit = fitter.extend_disc(radii[scale]);
      is_smooth[v] = is_usable(fit) && fits_well(fit, noise.sigma[v]) &&
                     !exceeds_graph_limit(
                         tensor_of(fit, removes_bias), radii[scale],
                         three_sigma_of(isotropic_variance(fit),
                                        noise.sigma[v] * std::sqrt(noise.transfer.curvature_ratio(radii[scale]))));
    }
  });
  return is_smooth;
}

void fall_back_to_jets(const Surface& surface, const std::vector<Vec3>& normals, const NoiseLevel& noise,
                       const Creases& creases, bool removes_bias, TensorField& tensors, ValidScales& balls,
                       Execution& execution)
{
  const std::size_t n = surface.vertex_count(), scales = tensors.radii().size();
  std::vector<std::uint32_t> cut;
  for_each_in_order(n, execution, [&](std::size_t v) {
    if (surface.is_referenced(v) && !has_all_balls(v, balls, scales)) cut.push_back(std::uint32_t(v));
  });
  if (cut.empty()) return;
  resize_in_steps(balls.row, n, execution);
  for_each_index(cut.size(), execution, [&](std::size_t i) { balls.row[cut[i]] = std::uint32_t(i); });
  resize_in_steps(balls.variances, cut.size() * scales, execution);
  JetFitters fitters(surface, execution, creases.is_crease);
  parallel_for(
      cut.size(), 64, execution,
      [&](std::size_t begin, std::size_t end, int worker) {
        JetFitter& fitter = fitters.of(worker);
        for (std::size_t i = begin; i < end; ++i) {
          const std::uint32_t v = cut[i];
          substitute_discs_at({v, noise, tensors, balls}, normals[v], creases, removes_bias, fitter);
        }
      },
      0.15, 0.2);
}

}  // namespace integral_invariant
