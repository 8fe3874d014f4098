// SPDX-License-Identifier: GPL-3.0-or-later
// The method of [Lai09] from mesh to curvatures: the paper's five steps, one call each. Everything between the checked
// surface and the result is in normalised units (average edge length 1).
#include "integral_invariant/pipeline.h"

#include <string>
#include <utility>

#include "integral_invariant/curvature/scale_blend.h"
#include "integral_invariant/moments/engine.h"
#include "integral_invariant/radius/feature_adapted.h"
#include "integral_invariant/radius/scales.h"
#include "integral_invariant/radius/smoothing.h"
#include "integral_invariant/support/memory.h"

namespace integral_invariant {

namespace {

/// Step 1: moments and tensors at all scales.
TensorField tensors_at_all_scales(const Surface& surface, const MomentEngine& engine, const std::vector<double>& radii,
                                  Execution& execution)
{
  TensorField tensors(surface.vertex_count(), radii);
  engine.evaluate(
      radii,
      [&](std::size_t vertex, int scale, const BallMoments& moments) {
        tensors.set(vertex, scale, curvature_tensor(moments, radii[scale]));
      },
      execution);
  return tensors;
}

/// Steps 2 to 4: the radius of every vertex, within the range of the scales.
std::vector<double> adapted_radii(const Surface& surface, const TensorField& tensors, const Parameters& p,
                                  Result& result, Execution& execution)
{
  execution.begin_stage("initial radius", 82);
  std::vector<double> start = start_radii(tensors, p.start_radius, execution);

  execution.begin_stage("radius iteration", 94);
  AdaptedRadii adapted = adapt_radii(tensors, std::move(start), p, execution);
  result.converged = adapted.converged;
  result.mean_iterations = adapted.mean_iterations;
  result.largest_iterations = adapted.largest_iterations;
  if (!p.smooth_radius) return std::move(adapted.radius);

  execution.begin_stage("radius smoothing", 96);
  return smooth_radii(surface, std::move(adapted.radius), p.smoothing_passes, execution);
}

/// Step 5: curvatures and directions at the radius, in the caller's unit.
void write_curvatures(const TensorField& tensors, const std::vector<double>& radii, double unit, Result& result,
                      Execution& execution)
{
  const std::size_t n = tensors.vertex_count();
  for (auto* values : {&result.kappa_max, &result.kappa_min, &result.radius}) values->resize(n);
  for (auto* vectors : {&result.dir_max, &result.dir_min, &result.normal}) vectors->resize(n);
  result.confidence.resize(n);
  parallel_for(n, 2048, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t v = begin; v < end; ++v) {
      const CurvatureTensor tensor = tensors.at_radius(v, radii[v]);
      const PrincipalCurvatures principal = principal_curvatures(tensor);
      result.kappa_max[v] = principal.kappa_max / unit;
      result.kappa_min[v] = principal.kappa_min / unit;
      result.dir_max[v] = principal.dir_max;
      result.dir_min[v] = principal.dir_min;
      result.normal[v] = tensor.normal;
      result.radius[v] = radii[v] * unit;
      result.confidence[v] = float(tensor.confidence);
    }
  });
}

void describe_run(const Surface& surface, const MomentEngine& engine, const std::vector<double>& scales,
                  const Execution& execution, Result& result)
{
  result.surface = surface.report();
  for (const double r : scales) result.scales.push_back(r * surface.unit());
  result.average_edge = surface.unit();
  result.diagonal = surface.diagonal() * surface.unit();
  result.engine = engine.description(scales, execution);
  result.stages = execution.stage_times();
}

/// What the arrays of a run take, over and above the engine's own.
void require_memory_for_arrays(std::size_t vertices, std::size_t scales, std::size_t limit_mb)
{
  constexpr std::size_t result_bytes = 3 * sizeof(double) + 3 * sizeof(Vec3) + sizeof(float);
  constexpr std::size_t radius_bytes = 3 * sizeof(double);
  const double bytes = double(vertices) * double(TensorField::bytes_per_vertex(scales) + result_bytes + radius_bytes);
  require_memory(bytes, limit_mb, "Curvature at " + std::to_string(scales) + " scales of " + std::to_string(vertices) +
                 " vertices", "Reduce scales or the number of vertices");
}

}  // namespace

Result compute_curvature(const TriangleMesh& mesh, const Parameters& parameters, const ProgressCallback& progress)
{
  validate(parameters);
  Execution execution(parameters.threads, progress);
  Result result;

  execution.begin_stage("checking the surface", 4);
  const Surface surface(mesh);
  const std::vector<double> scales = scale_radii(parameters, surface.unit());
  require_memory_for_arrays(surface.vertex_count(), scales.size(), parameters.memory_limit_mb);

  execution.begin_stage("ball moments", 80);
  const auto engine = make_moment_engine(surface, parameters);
  const TensorField tensors = tensors_at_all_scales(surface, *engine, scales, execution);

  std::vector<double> radii(surface.vertex_count(), scales.front());
  result.converged = radii.size();
  if (scales.size() > 1) radii = adapted_radii(surface, tensors, parameters, result, execution);

  execution.begin_stage("principal curvatures", 100);
  write_curvatures(tensors, radii, surface.unit(), result, execution);
  execution.finish();

  describe_run(surface, *engine, scales, execution, result);
  return result;
}

}  // namespace integral_invariant
