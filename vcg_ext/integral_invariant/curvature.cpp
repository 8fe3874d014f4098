// SPDX-License-Identifier: GPL-3.0-or-later
// The method of [Lai09] from mesh to curvatures: the paper's five steps, one call each; or all scales at once, weighted
// by their evidence. Everything between the checked surface and the result is in normalised units (average edge length
// 1) and in canonical order.
#include "integral_invariant/curvature.h"

#include <cstdint>
#include <sstream>
#include <string>
#include <utility>

#include "integral_invariant/ball_curvature/ball_bias.h"
#include "integral_invariant/ball_curvature/offset_free.h"
#include "integral_invariant/ball_curvature/tensor_field.h"
#include "integral_invariant/error.h"
#include "integral_invariant/jets/jet_fit.h"
#include "integral_invariant/mesh/canonical_mesh.h"
#include "integral_invariant/mesh/principal_axes.h"
#include "integral_invariant/moments/engine.h"
#include "integral_invariant/moments/scales.h"
#include "integral_invariant/multiscale/correlated_noise.h"
#include "integral_invariant/multiscale/estimator.h"
#include "integral_invariant/multiscale/outliers.h"
#include "integral_invariant/published/radius_iteration.h"
#include "integral_invariant/published/radius_smoothing.h"
#include "integral_invariant/support/memory.h"

namespace integral_invariant {

namespace {

/// Step 1 as published: moments and tensors at all scales.
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

/// Step 1 with the ball's centre taken for noisy: tensors, and how far the surface is off the centre (n × scales).
struct OffsetFreeField {
  TensorField tensors;
  std::vector<float> offsets;
};

OffsetFreeField offset_free_at_all_scales(const Surface& surface, const MomentEngine& engine,
                                          const std::vector<double>& radii, Execution& execution)
{
  OffsetFreeField field{TensorField(surface.vertex_count(), radii), {}};
  resize_in_steps(field.offsets, surface.vertex_count() * radii.size(), execution);
  engine.evaluate(
      radii,
      [&](std::size_t vertex, int scale, const BallMoments& moments) {
        const OffsetFreeMeasure measure = offset_free_measure(moments, radii[scale]);
        field.tensors.set(vertex, scale, measure.tensor);
        field.offsets[vertex * radii.size() + scale] = float(measure.offset);
      },
      execution);
  return field;
}

void remove_bias(OffsetFreeField& field, Execution& execution)
{
  const std::vector<double>& radii = field.tensors.radii();
  for_each_index(field.tensors.vertex_count(), execution, [&](std::size_t v) {
    for (std::size_t i = 0; i < radii.size(); ++i)
      field.tensors.set(
          v, int(i),
          correct_ball_bias(field.tensors.at_scale(v, int(i)), radii[i], field.offsets[v * radii.size() + i], 0));
  });
  extrapolate_to_zero_radius(field.tensors, execution);
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

void resize_result(std::size_t n, Result& result, Execution& execution)
{
  for (auto* values : {&result.kappa_max, &result.kappa_min, &result.radius, &result.standard_error})
    resize_in_steps(*values, n, execution);
  for (auto* vectors : {&result.dir_max, &result.dir_min, &result.normal}) resize_in_steps(*vectors, n, execution);
  resize_in_steps(result.confidence, n, execution);
}

/// Writes what a tensor says about vertex v, in the caller's unit.
void write_vertex(const CurvatureTensor& tensor, double radius, double unit, std::size_t v, Result& result)
{
  const PrincipalCurvatures principal = principal_curvatures(tensor);
  result.kappa_max[v] = principal.kappa_max / unit;
  result.kappa_min[v] = principal.kappa_min / unit;
  result.dir_max[v] = principal.dir_max;
  result.dir_min[v] = principal.dir_min;
  result.normal[v] = tensor.normal;
  result.radius[v] = radius * unit;
  result.confidence[v] = float(tensor.confidence);
}

/// Steps 2 to 5: a radius for every vertex, and curvatures and directions there. `original_index`: see CanonicalMesh.
void curvature_at_one_radius(const Surface& surface, const std::vector<std::uint32_t>& original_index,
                             const TensorField& tensors, const Parameters& p, Result& result, Execution& execution)
{
  std::vector<double> radii(surface.vertex_count(), tensors.radii().front());
  execution.check();
  result.converged = radii.size();
  if (tensors.radii().size() > 1) radii = adapted_radii(surface, tensors, p, result, execution);

  execution.begin_stage("principal curvatures", 100);
  parallel_for(radii.size(), 2048, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t v = begin; v < end; ++v)
      write_vertex(tensors.at_radius(v, radii[v]), radii[v], surface.unit(), original_index[v], result);
  });
}

/// Steps 2 to 5 by statistics: all scales of every vertex, weighted by their evidence.
void curvature_by_evidence(const Surface& surface, const std::vector<std::uint32_t>& original_index,
                           const CoordinateLattice& lattice, OffsetFreeField field, const Parameters& p, Result& result,
                           Execution& execution)
{
  execution.begin_stage("noise", 83);
  const std::vector<Jet> fits = fit_jets(surface, field.tensors, execution);
  NoiseLevel noise =
      estimate_noise_level(surface, field.tensors, field.offsets, fits, p.noise / surface.unit(), execution);
  if (!(p.noise > 0))
    add_correlated_noise(find_correlated_noise(surface, lattice, field.tensors, execution), noise, execution);
  result.noise_correlation = noise.transfer.correlation() * surface.unit();

  execution.begin_stage("weighing the scales", 99);
  const MultiscaleCurvature best =
      estimate_multiscale(surface, field.tensors, field.offsets, fits, noise, p.estimator, execution);

  execution.begin_stage("principal curvatures", 100);
  result.converged = surface.vertex_count();
  result.noise = noise.mean_sigma * surface.unit();
  for_each_index(best.tensor.size(), execution, [&](std::size_t v) {
    write_vertex(best.tensor[v], best.radius[v], surface.unit(), original_index[v], result);
    result.standard_error[original_index[v]] = best.standard_error[v] / surface.unit();
  });
}

/// Noise beyond this, in average edge lengths, leaves nothing to measure, and its powers overflow.
void require_sensible_noise(double noise, double unit)
{
  constexpr double largest_noise = 1000;
  if (noise / unit <= largest_noise) return;
  std::ostringstream text;
  text << "The parameter 'noise' is " << noise << ", more than " << largest_noise << " average edge lengths (" << unit
       << "). Give the standard deviation in the unit of the mesh, or 0 to have it estimated.";
  throw ParameterError(text.str());
}

/// Directions along `axes`, as the caller has them.
void turn_back(const Axes& axes, Result& result, Execution& execution)
{
  for (auto* vectors : {&result.dir_max, &result.dir_min, &result.normal})
    for_each_index(vectors->size(), execution, [&](std::size_t v) { (*vectors)[v] = axes.vector((*vectors)[v]); });
}

/// Every vertex of the caller that is a copy of one that was measured gets what that one has.
void give_to_copies(const CanonicalMesh& canonical, Result& result)
{
  for (auto* values : {&result.kappa_max, &result.kappa_min, &result.radius, &result.standard_error})
    canonical.give_to_copies(*values);
  for (auto* vectors : {&result.dir_max, &result.dir_min, &result.normal}) canonical.give_to_copies(*vectors);
  canonical.give_to_copies(result.confidence);
}

void describe_run(const Surface& surface, const std::vector<double>& scales, const Execution& execution, Result& result)
{
  result.surface = surface.report();
  for (const double r : scales) result.scales.push_back(r * surface.unit());
  result.average_edge = surface.unit();
  result.diagonal = surface.diagonal() * surface.unit();
  result.stages = execution.stage_times();
}

/// Vertices that stand out of the surface alone go back to it, and the surface is taken anew; again, while there are
/// some, because two that stand side by side hide each other. Returns how many.
std::size_t set_back_outliers(TriangleMesh& mesh, Surface& surface, Execution& execution)
{
  constexpr int most_rounds = 3;
  std::size_t count = 0;
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<Outlier> outliers = find_outliers(surface, execution);
    if (outliers.empty()) break;
    for (const Outlier& outlier : outliers)
      mesh.positions[outlier.vertex] += (outlier.place - surface.positions()[outlier.vertex]) * surface.unit();
    count += outliers.size();
    surface = Surface(mesh, execution);
  }
  return count;
}

/// What the arrays of a run take, over and above the engine's own.
void require_memory_for_arrays(std::size_t vertices, std::size_t scales, std::size_t limit_mb)
{
  constexpr std::size_t result_bytes = 4 * sizeof(double) + 3 * sizeof(Vec3) + sizeof(float);
  constexpr std::size_t radius_bytes = 3 * sizeof(double) + sizeof(Jet) + sizeof(std::uint32_t);
  const double bytes = double(vertices) * double(TensorField::bytes_per_vertex(scales) + result_bytes + radius_bytes);
  require_memory(bytes, limit_mb,
                 "Curvature at " + std::to_string(scales) + " scales of " + std::to_string(vertices) + " vertices",
                 "Reduce scales or the number of vertices");
}

}  // namespace

Result compute_curvature(const TriangleMesh& mesh, const Parameters& parameters, const ProgressCallback& progress)
{
  validate(parameters);
  Execution execution(parameters.threads, progress);
  Result result;

  execution.begin_stage("checking the surface", 4);
  const bool is_statistical = parameters.radius_choice == RadiusChoice::statistical;
  // The averages over neighbourhoods would see the caller's axes. The FFT engine's grid does in any case.
  const bool is_turned = is_statistical && parameters.engine == EngineKind::surface_integral;
  const Axes axes = is_turned ? principal_axes(mesh, execution) : Axes{};
  CanonicalMesh canonical = make_canonical_mesh(mesh, execution, axes);
  execution.report(0.5);
  Surface surface(canonical.mesh, execution);
  if (is_statistical && parameters.estimator != Estimator::yang06)
    result.outliers = set_back_outliers(canonical.mesh, surface, execution);
  canonical.mesh = {};  // the surface has its own
  CoordinateLattice lattice = find_coordinate_lattice(surface);
  if (is_turned) {
    surface.turn_to(axes, execution);
    lattice.axes = axes;
  }
  const std::vector<std::uint32_t>& original_index = canonical.original_index;
  const std::vector<double> scales = scale_radii(parameters, surface.unit());
  require_sensible_noise(parameters.noise, surface.unit());
  require_memory_for_arrays(mesh.positions.size(), scales.size(), parameters.memory_limit_mb);

  execution.begin_stage("ball moments", 80);
  auto engine = make_moment_engine(surface, parameters, execution);
  result.engine = engine->description(scales, execution);
  execution.report(0);
  if (parameters.estimator == Estimator::yang06) {
    const TensorField tensors = tensors_at_all_scales(surface, *engine, scales, execution);
    engine.reset();  // before the arrays of the result: both would be the peak of memory
    resize_result(mesh.positions.size(), result, execution);
    curvature_at_one_radius(surface, original_index, tensors, parameters, result, execution);
  } else {
    OffsetFreeField field = offset_free_at_all_scales(surface, *engine, scales, execution);
    engine.reset();
    resize_result(mesh.positions.size(), result, execution);
    if (is_statistical) {
      curvature_by_evidence(surface, original_index, lattice, std::move(field), parameters, result, execution);
      if (is_turned) turn_back(axes, result, execution);
    } else {
      if (parameters.estimator == Estimator::bias_free) remove_bias(field, execution);
      curvature_at_one_radius(surface, original_index, field.tensors, parameters, result, execution);
    }
  }
  give_to_copies(canonical, result);
  execution.finish();

  describe_run(surface, scales, execution, result);
  canonical.complete(result.surface);
  return result;
}

}  // namespace integral_invariant
