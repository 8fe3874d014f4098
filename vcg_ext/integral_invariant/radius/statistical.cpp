// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: statistical choice of the scales. In: offset-free tensors of all scales, noise. Out: tensor, standard error
// and radius of every vertex. Cost: O(n · scales). Source: docs/method.md §4, docs/accuracy.md.
#include "integral_invariant/radius/statistical.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "integral_invariant/curvature/bias.h"
#include "integral_invariant/curvature/offset_free.h"
#include "integral_invariant/curvature/vertex_fit.h"
#include "integral_invariant/radius/scale_chain.h"
#include "integral_invariant/radius/vertex_step.h"
#include "integral_invariant/radius/whole_balls.h"

namespace integral_invariant {

namespace {

/// Tangent frame of a vertex in which its tensors of all scales are compared.
struct Frame {
  Vec3 normal, u, v;
};

/// `a` turned as the shortest rotation turns `from` to `to`.
Vec3 turned(const Vec3& a, const Vec3& from, const Vec3& to)
{
  const double cosine = dot(from, to);
  if (cosine < -0.99) return a;
  const Vec3 axis = cross(from, to), once = cross(axis, a);
  return a + once + cross(axis, once) * (1 / (1 + cosine));
}

/// The normal is that of a small ball, the frame the principal one of the largest, which has the least noise: a frame
/// that follows the noise of what it is to judge would pass it for shape.
Frame frame_of(std::size_t vertex, const TensorField& tensors, const WholeBalls& balls)
{
  constexpr int usual_scale = 3;  // small, but not the prey of noise
  const std::size_t scales = tensors.radii().size();
  int scale = std::min(usual_scale, balls.largest[vertex]);
  while (scale < balls.largest[vertex] && balls.origin[vertex * scales + std::size_t(scale)] == Origin::none) ++scale;
  const Vec3 normal = tensors.at_scale(vertex, scale).normal;
  const CurvatureTensor smoothest = tensors.at_scale(vertex, balls.largest[vertex]);
  const Vec3 u = turned(principal_curvatures(smoothest).dir_max, smoothest.normal, normal);
  return {normal, u, cross(normal, u)};
}

struct Signals {
  Signal mean, deviator, normal;
};

/// A tensor as its vertex's frame sees it.
struct Components {
  double mean;
  std::array<double, 2> deviator, normal;
};

Components components_of(const CurvatureTensor& t, const Frame& f)
{
  const Vec3 a = turned(f.u, f.normal, t.normal), b = turned(f.v, f.normal, t.normal), kb = t.k * b;
  const double aa = quadratic_form(t.k, a), bb = dot(b, kb);
  return {(aa + bb) / 2, {(aa - bb) / 2, dot(a, kb)}, {dot(t.normal, f.u), dot(t.normal, f.v)}};
}

Signals make_signals(const TensorField& tensors, const WholeBalls& balls, const std::vector<Frame>& frames,
                     const Noise& noise, Execution& execution)
{
  const std::size_t n = frames.size(), scales = tensors.radii().size(), places = n * scales;
  Signals s{{1, Evidence::joint, places}, {2, Evidence::each, places}, {2, Evidence::each, places}};
  parallel_for(
      n, 2048, execution,
      [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t v = begin; v < end; ++v)
          for (std::size_t i = 0; i < scales; ++i) {
            const std::size_t place = v * scales + i;
            const Components c = components_of(tensors.at_scale(v, int(i)), frames[v]);
            s.mean.values[place] = {float(c.mean), 0};
            s.deviator.values[place] = {float(c.deviator[0]), float(c.deviator[1])};
            s.normal.values[place] = {float(c.normal[0]), float(c.normal[1])};
            if (balls.origin[place] == Origin::vertices) {
              const std::array<float, 3>& variance = balls.variance[place];
              const float square = float(noise.sigma[v] * noise.sigma[v]);
              s.mean.noise[place] = variance[0] * square;
              s.deviator.noise[place] = variance[1] * square;
              s.normal.noise[place] = variance[2] * square;
              continue;
            }
            const double r2 = tensors.radii()[i] * tensors.radii()[i], density = noise.density[v];
            const double flat = noise.flatness[v] * noise.flatness[v] / (r2 * r2 * r2 * r2);
            s.mean.noise[place] = float(disc_variance::mean_curvature * density / (r2 * r2 * r2) + flat);
            s.deviator.noise[place] = float(disc_variance::deviator * density / (r2 * r2 * r2) + flat);
            s.normal.noise[place] = float(disc_variance::normal * density / (r2 * r2));
          }
      },
      0.2, 0.3);
  return s;
}

struct ChainResults {
  ChainResult mean, deviator, normal;
};

ChainResults run_chains(const Signals& signals, const ScaleEvidence& evidence, Execution& execution)
{
  ScaleChain chain(evidence, execution);
  ChainResults results;
  results.mean = chain.run(signals.mean);
  execution.report(0.65);
  results.deviator = chain.run(signals.deviator);
  execution.report(0.8);
  results.normal = chain.run(signals.normal);
  execution.report(0.95);
  return results;
}

struct FittedSignals {
  FittedSignal mean, deviator, normal;
};

/// Fits that reach over a crease, and those beside them: a polynomial overshoots it, and swings to both sides of it.
std::vector<char> near_creases(const Surface& surface, const std::vector<VertexFit>& fits, Execution& execution)
{
  constexpr double largest_kr = 1.3;
  std::vector<char> near(fits.size(), 0);
  for_each_in_order(fits.size(), execution, [&](std::size_t v) {
    if (!(largest_absolute_curvature(fits[v].tensor) * fits[v].reach > largest_kr)) return;
    near[v] = 1;
    for (std::uint32_t e = surface.neighbour_start()[v]; e < surface.neighbour_start()[v + 1]; ++e)
      near[surface.neighbours()[e]] = 1;
  });
  return near;
}

FittedSignals make_fitted_signals(const Surface& surface, const std::vector<VertexFit>& fits,
                                  const std::vector<Frame>& frames, const Noise& noise, Execution& execution)
{
  constexpr double evident_residual = 6, evident_terms = 1.5, least_variance = 1e-20;
  const std::size_t n = fits.size();
  const std::vector<char> is_near_crease = near_creases(surface, fits, execution);
  FittedSignals s{{1, Evidence::joint, {}, {}, {}}, {2, Evidence::each, {}, {}, {}}, {2, Evidence::each, {}, {}, {}}};
  for (FittedSignal* signal : {&s.mean, &s.deviator, &s.normal}) {
    resize_in_steps(signal->values, n, execution);
    resize_in_steps(signal->error, n, execution);
    resize_in_steps(signal->noise, n, execution, double(INFINITY));
  }
  for_each_index(n, execution, [&](std::size_t v) {
    const VertexFit& fit = fits[v];
    if (!(fit.tensor.confidence > 0) || is_near_crease[v]) return;
    const Components c = components_of(fit.tensor, frames[v]);
    double variance = noise.sigma[v] * noise.sigma[v];
    if (fit.residual > evident_residual * variance) variance = fit.residual;
    // A polynomial that only shape leaves over is as exact as its residual is small, and better than any ball.
    const bool is_shape = fit.last_terms > evident_terms * fit.residual;
    const double noise_share = is_shape ? 1 - noise.shape_share[v] : 1;
    const double of_noise = std::max(variance * noise_share, least_variance);
    variance = std::max(variance, least_variance);
    s.mean.values[v] = {c.mean, 0};
    s.deviator.values[v] = c.deviator;
    s.normal.values[v] = c.normal;
    const std::pair<FittedSignal*, double> parts[] = {
        {&s.mean, fit.mean_variance}, {&s.deviator, fit.deviator_variance}, {&s.normal, fit.normal_variance}};
    for (const auto& [signal, of_part] : parts) {
      signal->noise[v] = of_part * of_noise;
      signal->error[v] = of_part * variance;
    }
  });
  return s;
}

void remove_own_bias(TensorField& tensors, const Noise& noise, Execution& execution)
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
            tensors.set(v, int(i), without_own_bias(tensors.at_scale(v, int(i)), radii[i], noise.offset[v], variance));
          }
      },
      0, 0.1);
}

CurvatureTensor assemble(const Frame& f, double mean, const std::array<double, 2>& deviator,
                         const std::array<double, 2>& tilt)
{
  const double in_plane = std::min(0.99, tilt[0] * tilt[0] + tilt[1] * tilt[1]);
  const Vec3 normal = normalized(f.u * tilt[0] + f.v * tilt[1] + f.normal * std::sqrt(1 - in_plane), f.normal);
  const Vec3 u = turned(f.u, f.normal, normal), v = turned(f.v, f.normal, normal);
  const Symmetric3 k =
      outer(u) * (mean + deviator[0]) + outer(v) * (mean - deviator[0]) + symmetric_outer(u, v) * deviator[1];
  return {k, normal, 1};
}

}  // namespace

StatisticalCurvature combine_scales(const Surface& surface, TensorField& tensors, const std::vector<float>& offsets,
                                    const std::vector<VertexFit>& fits, const Noise& noise, Estimator estimator,
                                    Execution& execution)
{
  const std::size_t n = surface.vertex_count();
  const std::vector<double>& radii = tensors.radii();
  const bool removes_bias = estimator == Estimator::bias_free;
  if (removes_bias) remove_own_bias(tensors, noise, execution);
  const WholeBalls balls = find_whole_balls(surface, offsets, fits, noise, removes_bias, tensors, execution);

  std::vector<Frame> frames;
  std::vector<double> least_radius;
  resize_in_steps(frames, n, execution);
  resize_in_steps(least_radius, n, execution);
  for_each_index(n, execution, [&](std::size_t v) {
    frames[v] = frame_of(v, tensors, balls);
    least_radius[v] = least_radius_over_sigma * noise.sigma[v];
  });
  const Signals signals = make_signals(tensors, balls, frames, noise, execution);

  constexpr double pool_over_radius = 2, least_pool = 8;
  std::vector<GridPool> pools;
  for (std::size_t i = 0; i + 1 < radii.size(); ++i) {
    pools.emplace_back(surface.positions(), std::max(least_pool, pool_over_radius * radii[i + 1]), execution);
    execution.report(0.3 + 0.2 * double(i) / double(radii.size()));
  }
  const ScaleEvidence evidence{radii, balls, least_radius, pools, removes_bias};
  ChainResults chains = run_chains(signals, evidence, execution);
  if (removes_bias) {
    const FittedSignals fitted = make_fitted_signals(surface, fits, frames, noise, execution);
    add_vertex_step(fitted.mean, pools.front(), chains.mean, execution);
    add_vertex_step(fitted.deviator, pools.front(), chains.deviator, execution);
    add_vertex_step(fitted.normal, pools.front(), chains.normal, execution);
  }
  // Measured: variances are first order in the noise; slopes of strong noise make the errors larger.
  constexpr double second_order = 1.5;
  StatisticalCurvature result;
  resize_in_steps(result.tensor, n, execution);
  resize_in_steps(result.standard_error, n, execution);
  for_each_index(n, execution, [&](std::size_t v) {
    result.tensor[v] = assemble(frames[v], chains.mean.value[v][0], chains.deviator.value[v], chains.normal.value[v]);
    result.tensor[v].confidence = tensors.at_scale(v, balls.largest[v]).confidence;
    const double variance = std::max(0.0, chains.mean.variance[v][0] + chains.deviator.variance[v][0]);
    result.standard_error[v] = std::sqrt(variance * (1 + second_order * noise.sigma[v] * noise.sigma[v]));
  });
  result.radius = std::move(chains.mean.radius);
  return result;
}

}  // namespace integral_invariant
