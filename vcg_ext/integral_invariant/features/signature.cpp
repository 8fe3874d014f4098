// SPDX-License-Identifier: GPL-3.0-or-later
// Multi-scale signature. In: a mesh and the radii. Out: three numbers a scale and vertex. Cost: that of the moment
// engine. Source: volume invariant of [Pottmann07]; curvatures of [Yang06].
#include "integral_invariant/features/signature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "integral_invariant/ball_curvature/curvature_tensor.h"
#include "integral_invariant/error.h"
#include "integral_invariant/mesh/canonical_mesh.h"
#include "integral_invariant/moments/engine.h"
#include "integral_invariant/moments/scales.h"
#include "integral_invariant/support/memory.h"
#include "integral_invariant/support/pi.h"

namespace integral_invariant {

namespace {

double volume_invariant(double volume, double radius)
{
  return std::clamp(1 - 2 * volume / (4.0 / 3 * pi * radius * radius * radius), -1.0, 1.0);
}

/// In single precision, which a mesh in very small units leaves.
float storable(double value)
{
  constexpr double largest = std::numeric_limits<float>::max();
  return float(std::clamp(value, -largest, largest));
}

void allocate(Signature& signature, std::size_t vertices, std::size_t scales, std::size_t limit_mb,
              Execution& execution)
{
  const double bytes = double(vertices) * double(scales) * signature_quantity_count * sizeof(float);
  require_memory(bytes, limit_mb,
                 "The signature of " + std::to_string(vertices) + " vertices at " + std::to_string(scales) + " scales",
                 "Reduce scales or the number of vertices");
  for (auto& quantity : signature.values) {
    quantity.resize(scales);
    for (std::vector<float>& of_scale : quantity) resize_in_steps(of_scale, vertices, execution);
  }
}

}  // namespace

Signature compute_signature(const TriangleMesh& mesh, const Parameters& parameters, const ProgressCallback& progress)
{
  Parameters ladder =
      parameters;  // a signature has the scales it is asked for, however curvature would choose its radius
  ladder.radius_choice = RadiusChoice::feature_adapted;
  validate(ladder);
  Execution execution(parameters.threads, progress);
  execution.begin_stage("checking the surface", 4);
  CanonicalMesh canonical = make_canonical_mesh(mesh, execution);
  execution.report(0.5);
  const Surface surface(canonical.mesh, execution);
  canonical.mesh = {};  // the surface has its own
  const std::vector<double> radii = scale_radii(ladder, surface.unit());
  Signature signature;
  allocate(signature, mesh.positions.size(), radii.size(), parameters.memory_limit_mb, execution);

  execution.begin_stage("ball moments", 100);
  const auto engine = make_moment_engine(surface, parameters, execution);
  const double unit = surface.unit();
  engine->evaluate(
      radii,
      [&](std::size_t vertex, int scale, const BallMoments& moments) {
        const std::size_t v = canonical.original_index[vertex];
        const PrincipalCurvatures k = principal_curvatures(curvature_tensor(moments, radii[scale]));
        signature.values[0][scale][v] = storable(volume_invariant(moments.volume, radii[scale]));
        signature.values[1][scale][v] = storable((k.kappa_max + k.kappa_min) / (2 * unit));
        signature.values[2][scale][v] = storable((k.kappa_max - k.kappa_min) / unit);
      },
      execution);
  for (auto& quantity : signature.values)
    for (std::vector<float>& of_scale : quantity) canonical.give_to_copies(of_scale);
  signature.engine = engine->description(radii, execution);
  execution.finish();

  for (const double r : radii) signature.radii.push_back(r * unit);
  signature.surface = surface.report();
  canonical.complete(signature.surface);
  signature.average_edge = unit;
  signature.diagonal = surface.diagonal() * unit;
  signature.stages = execution.stage_times();
  return signature;
}

std::vector<double> reduce(const Signature& signature, const ReductionParameters& p)
{
  const auto& values = signature.of(p.quantity);
  const std::size_t scales = values.size(), n = scales ? values.front().size() : 0;
  if (p.reduction == Reduction::one_scale && (p.scale < 1 || std::size_t(p.scale) > scales))
    throw ParameterError("The parameter 'scale' is " + std::to_string(p.scale) + ", but there are scales 1 to " +
                         std::to_string(scales) + ".");
  if (p.reduction == Reduction::p_norm && !(p.p >= 1 && std::isfinite(p.p)))
    throw ParameterError("The parameter 'p' of the p-norm must be a finite number of at least 1.");
  if (p.reduction == Reduction::one_scale) {
    const auto& one = values[std::size_t(p.scale) - 1];
    return {one.begin(), one.end()};
  }
  std::vector<double> result(n);
  for (std::size_t v = 0; v < n; ++v) {
    double low = values[0][v], high = low, largest = 0, sum = 0;
    for (const auto& of_scale : values) {
      const double value = of_scale[v];
      low = std::min(low, value);
      high = std::max(high, value);
      largest = std::max(largest, std::abs(value));
    }
    if (p.reduction != Reduction::p_norm) {
      result[v] = p.reduction == Reduction::minimum ? low : high;
      continue;
    }
    // Relative to the largest, so that no power underflows.
    for (const auto& of_scale : values)
      if (largest > 0) sum += std::pow(std::abs(double(of_scale[v])) / largest, p.p);
    result[v] = largest * std::pow(sum / double(scales), 1 / p.p);
  }
  return result;
}

}  // namespace integral_invariant
