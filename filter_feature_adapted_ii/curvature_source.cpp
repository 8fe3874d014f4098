// SPDX-License-Identifier: GPL-3.0-or-later
// What filters that work on curvatures begin and end with.
#include "curvature_source.h"

#include "integral_invariant/parameters.h"
#include "integral_invariant/curvature.h"
#include "method_parameters.h"
#include "report.h"

namespace integral_invariant::filter {

namespace {

constexpr int curvature_share = 85;  // per cent of the whole

/// The same callback for the first `share` per cent of the whole.
ProgressCallback first_part(const ProgressCallback& progress, int share)
{
  if (!progress) return {};
  return [progress, share](int percent, const char* stage) { return progress(percent * share / 100, stage); };
}

/// The same for what follows.
ProgressCallback last_part(const ProgressCallback& progress, int share)
{
  if (!progress) return {};
  return [progress, share](int percent, const char* stage) {
    return progress(share + percent * (100 - share) / 100, stage);
  };
}

Execution begun(int threads, int end_percent, const ProgressCallback& progress)
{
  Execution execution(threads, progress);
  execution.begin_stage("checking the surface", end_percent);
  return execution;
}

CanonicalMesh canonical_mesh(const FilterInput& input, const ProgressCallback& progress)
{
  Execution execution = begun(input.request.part<Parameters>().threads, 0, progress);
  return make_canonical_mesh(input.mesh, execution);
}

}  // namespace

std::vector<ParameterSpec> curvature_source_parameters()
{
  return method_parameters({"radius_choice", "estimator", "scales", "r_min", "r_max", "radius", "engine", "alpha",
                            "smooth_radius", "memory_limit_mb"});
}

MeasuredMesh::MeasuredMesh(const FilterInput& input, const ProgressCallback& progress)
    : canonical(canonical_mesh(input, progress)),
      curvature(
          compute_curvature(canonical.mesh, input.request.part<Parameters>(), first_part(progress, curvature_share))),
      execution(begun(input.request.part<Parameters>().threads, 10, last_part(progress, curvature_share))),
      surface(canonical.mesh, execution)
{
  canonical.complete(curvature.surface);
}

void add_report(MeasuredMesh& measured, const char* title, const std::vector<std::string>& findings,
                FilterResult& result)
{
  measured.execution.finish();
  Result& curvature = measured.curvature;
  for (const StageTime& stage : measured.execution.stage_times()) curvature.stages.push_back(stage);
  result.log = {title};
  for (const auto& lines : {run_lines(curvature), defect_lines(curvature), findings})
    result.log.insert(result.log.end(), lines.begin(), lines.end());
  result.log.push_back(time_line(curvature));
  result.values.emplace_back("average_edge", curvature.average_edge);
  result.values.emplace_back("engine", curvature.engine);
  result.values.emplace_back("seconds", total_seconds(curvature));
}

}  // namespace integral_invariant::filter
