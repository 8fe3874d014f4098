// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: statistical choice of the scales. In: offset-free tensors of all scales, noise. Out: tensor, standard error
// and radius of every vertex. Cost: O(n · scales). Source: docs/method.md §12.
#include "integral_invariant/multiscale/estimator.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/ball_curvature/ball_bias.h"
#include "integral_invariant/ball_curvature/offset_free.h"
#include "integral_invariant/ball_curvature/tangent_frame.h"
#include "integral_invariant/multiscale/jet_fusion.h"
#include "integral_invariant/multiscale/jet_observations.h"
#include "integral_invariant/multiscale/scale_filter.h"
#include "integral_invariant/multiscale/tensor_prior.h"
#include "integral_invariant/multiscale/valid_scales.h"

namespace integral_invariant {

namespace {

/// The normal is that of a small ball, the frame the principal one of the largest, which has the least noise: a frame
/// that follows the noise of what it is to judge would pass it for shape.
TangentFrame frame_of(std::size_t vertex, const TensorField& tensors, const ValidScales& balls)
{
  constexpr int usual_scale = 3;  // small, but not the prey of noise
  const std::size_t scales = tensors.radii().size();
  int scale = std::min(usual_scale, balls.largest[vertex]);
  while (scale < balls.largest[vertex] && balls.source[vertex * scales + std::size_t(scale)] == Source::none) ++scale;
  const Vec3 normal = tensors.at_scale(vertex, scale).normal;
  const CurvatureTensor smoothest = tensors.at_scale(vertex, balls.largest[vertex]);
  const Vec3 u = rotate_to(principal_curvatures(smoothest).dir_max, smoothest.normal, normal);
  return {normal, u, cross(normal, u)};
}

struct Signals {
  Signal mean, deviator, normal;
};

Signals make_signals(const TensorField& tensors, const ValidScales& balls, const std::vector<TangentFrame>& frames,
                     const NoiseLevel& noise, Execution& execution)
{
  const std::size_t n = frames.size(), scales = tensors.radii().size(), places = n * scales;
  Signals s{{1, GainSharing::joint, places}, {2, GainSharing::each, places}, {2, GainSharing::each, places}};
  parallel_for(
      n, 2048, execution,
      [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t v = begin; v < end; ++v)
          for (std::size_t i = 0; i < scales; ++i) {
            const std::size_t place = v * scales + i;
            const TensorComponents c = components_of(tensors.at_scale(v, int(i)), frames[v]);
            s.mean.values[place] = {float(c.mean), 0};
            s.deviator.values[place] = {float(c.deviator[0]), float(c.deviator[1])};
            s.normal.values[place] = {float(c.tilt[0]), float(c.tilt[1])};
            if (balls.source[place] == Source::jet) {
              const DiscVariance& variance = balls.variance(v, i);
              const double square = noise.sigma[v] * noise.sigma[v], r = tensors.radii()[i];
              const float of_curvature = float(square * noise.transfer.curvature_ratio(r));
              s.mean.noise[place] = variance.mean() * of_curvature;
              s.deviator.noise[place] = variance.deviator() * of_curvature;
              s.normal.noise[place] = variance.normal * float(square * noise.transfer.normal_ratio(r));
              continue;
            }
            const double r = tensors.radii()[i], r2 = r * r, density = noise.density[v];
            const double curvature_ratio = noise.transfer.curvature_ratio(r),
                         normal_ratio = noise.transfer.normal_ratio(r);
            const double flat = noise.faceting_error[v] * noise.faceting_error[v] / (r2 * r2 * r2 * r2);
            s.mean.noise[place] =
                float(disc_variance::mean_curvature * curvature_ratio * density / (r2 * r2 * r2) + flat);
            s.deviator.noise[place] =
                float(disc_variance::deviator * curvature_ratio * density / (r2 * r2 * r2) + flat);
            s.normal.noise[place] = float(disc_variance::normal * normal_ratio * density / (r2 * r2));
          }
      },
      0.2, 0.3);
  return s;
}

struct FilteredSignals {
  FilteredSignal mean, deviator, normal;
};

FilteredSignals run_chains(const Signals& signals, const FilterContext& evidence, Execution& execution)
{
  ScaleFilter chain(evidence, execution);
  FilteredSignals results;
  results.mean = chain.run(signals.mean);
  execution.report(0.65);
  results.deviator = chain.run(signals.deviator);
  execution.report(0.8);
  results.normal = chain.run(signals.normal);
  execution.report(0.95);
  return results;
}

void remove_own_bias(TensorField& tensors, const NoiseLevel& noise, Execution& execution)
{
  // Half of a vertex's variance is left where triangles average their three corners.
  constexpr double surface_share = 0.5;
  const std::vector<double>& radii = tensors.radii();
  parallel_for(
      tensors.vertex_count(), 2048, execution,
      [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t v = begin; v < end; ++v)
          for (std::size_t i = 0; i < radii.size(); ++i) {
            const double variance = surface_share * noise.sigma[v] * noise.sigma[v];
            tensors.set(v, int(i), correct_ball_bias(tensors.at_scale(v, int(i)), radii[i], noise.offset[v], variance));
          }
      },
      0, 0.1);
}

/// The chains start from a vertex's largest disc, which may hardly tell its curvature in one direction; what they add
/// to it does not depend on it.
void shrink_starts(const std::vector<TangentFrame>& frames, const TensorField& tensors, const ValidScales& balls,
                   const Signals& signals, const NoiseLevel& noise, FilteredSignals& chains, Execution& execution)
{
  const std::size_t scales = tensors.radii().size();
  for_each_index(frames.size(), execution, [&](std::size_t v) {
    const std::size_t scale = std::size_t(balls.largest[v]), place = v * scales + scale;
    if (balls.source[place] != Source::jet) return;
    const Vec3 normal = tensors.at_scale(v, int(scale)).normal;
    const Vec3 u = rotate_to(frames[v].u, frames[v].normal, normal);
    const Symmetric3 covariance =
        balls.variance(v, scale).covariance_along(u, normal) *
        (noise.sigma[v] * noise.sigma[v] * noise.transfer.curvature_ratio(tensors.radii()[scale]));
    const Vec3 start{signals.mean.values[place][0], signals.deviator.values[place][0],
                     signals.deviator.values[place][1]};
    const PosteriorCurvature shrunk = posterior_curvature(start, covariance);
    const auto replace_start = [&](FilteredSignal& chain, const Signal& signal, std::size_t c, double value, double was,
                                   double variance) {
      chain.value[v][c] += value - was;
      chain.variance[v][c] = std::max(0.0, chain.variance[v][c] - double(signal.noise[place])) + variance;
    };
    replace_start(chains.mean, signals.mean, 0, shrunk.value.x, start.x, shrunk.variance.x);
    replace_start(chains.deviator, signals.deviator, 0, shrunk.value.y, start.y, shrunk.variance.y);
    replace_start(chains.deviator, signals.deviator, 1, shrunk.value.z, start.z, shrunk.variance.z);
  });
}

}  // namespace

MultiscaleCurvature estimate_multiscale(const Surface& surface, TensorField& tensors, const std::vector<float>& offsets,
                                        const std::vector<Jet>& fits, const NoiseLevel& noise, Estimator estimator,
                                        Execution& execution)
{
  const std::size_t n = surface.vertex_count();
  const std::vector<double>& radii = tensors.radii();
  const bool removes_bias = estimator == Estimator::bias_free;
  if (removes_bias) remove_own_bias(tensors, noise, execution);
  const ValidScales balls = find_valid_scales(surface, offsets, fits, noise, removes_bias, tensors, execution);

  std::vector<TangentFrame> frames;
  std::vector<double> least_radius;
  resize_in_steps(frames, n, execution);
  resize_in_steps(least_radius, n, execution);
  for_each_index(n, execution, [&](std::size_t v) {
    frames[v] = frame_of(v, tensors, balls);
    least_radius[v] = least_radius_over_sigma * noise.sigma[v];
  });
  const Signals signals = make_signals(tensors, balls, frames, noise, execution);

  constexpr double pool_over_radius = 2, least_pool = 8;
  std::vector<KernelSum> pools;
  for (std::size_t i = 0; i + 1 < radii.size(); ++i) {
    pools.emplace_back(surface.positions(), std::max(least_pool, pool_over_radius * radii[i + 1]), execution);
    execution.report(0.3 + 0.2 * double(i) / double(radii.size()));
  }
  const FilterContext evidence{radii, balls, least_radius, pools, removes_bias};
  FilteredSignals chains = run_chains(signals, evidence, execution);
  if (removes_bias) {
    shrink_starts(frames, tensors, balls, signals, noise, chains, execution);
    const JetObservations fitted = observe_jets(surface, fits, frames, noise, execution);
    fuse_jets(fitted.mean, pools.front(), chains.mean, execution);
    fuse_jets(fitted.deviator, pools.front(), chains.deviator, execution);
    fuse_jets(fitted.normal, pools.front(), chains.normal, execution);
  }
  // Measured: variances are first order in the noise; slopes of strong noise make the errors larger.
  constexpr double second_order = 1.5;
  MultiscaleCurvature result;
  resize_in_steps(result.tensor, n, execution);
  resize_in_steps(result.standard_error, n, execution);
  for_each_index(n, execution, [&](std::size_t v) {
    result.tensor[v] =
        tensor_of({chains.mean.value[v][0], chains.deviator.value[v], chains.normal.value[v]}, frames[v]);
    result.tensor[v].confidence = tensors.at_radius(v, chains.mean.radius[v]).confidence;
    const double variance = std::max(0.0, chains.mean.variance[v][0] + chains.deviator.variance[v][0]);
    result.standard_error[v] = std::sqrt(variance * (1 + second_order * noise.sigma[v] * noise.sigma[v]));
  });
  result.radius = std::move(chains.mean.radius);
  return result;
}

}  // namespace integral_invariant
