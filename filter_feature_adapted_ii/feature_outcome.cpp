// SPDX-License-Identifier: GPL-3.0-or-later
// The filters for features: from a mesh and a request to what is to be written.
#include "feature_outcome.h"

#include <algorithm>

#include "integral_invariant/mesh/canonical_mesh.h"
#include "integral_invariant/curvature.h"
#include "line_layer.h"

namespace integral_invariant::filter {

namespace {

constexpr Color neutral{208, 208, 208};

/// The same callback for a part of the whole, up to `share` per cent.
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

constexpr int curvature_share = 85;

/// Curvatures, and the stage that works on them.
struct Measured {
  Measured(const CanonicalMesh& canonical, const Request& request, const ProgressCallback& progress)
      : result(compute_curvature(canonical.mesh, request.method, first_part(progress, curvature_share))),
        execution(begun(request, last_part(progress, curvature_share))),
        surface(canonical.mesh, execution)
  {
    canonical.complete(result.surface);
  }

  Result result;
  Execution execution;
  Surface surface;

 private:
  static Execution begun(const Request& request, const ProgressCallback& progress)
  {
    Execution execution(request.method.threads, progress);
    execution.begin_stage("checking the surface", 10);
    return execution;
  }
};

CanonicalMesh canonical_mesh(const TriangleMesh& mesh, const Request& request, const ProgressCallback& progress)
{
  Execution execution(request.method.threads, progress);
  execution.begin_stage("checking the surface", 0);
  return make_canonical_mesh(mesh, execution);
}

/// The log of a run whose own findings are `lines`.
void add_log(Measured& measured, const char* title, const std::vector<std::string>& lines, FeatureOutcome& outcome)
{
  measured.execution.finish();
  Result& result = measured.result;
  for (const StageTime& stage : measured.execution.stage_times()) result.stages.push_back(stage);
  outcome.log = run_lines(result);
  outcome.log.insert(outcome.log.begin(), title);
  outcome.log.insert(outcome.log.end(), lines.begin(), lines.end());
  outcome.log.push_back(time_line(result));
  double seconds = 0;
  for (const StageTime& stage : result.stages) seconds += stage.seconds;
  outcome.values.emplace_back("average_edge", result.average_edge);
  outcome.values.emplace_back("engine", result.engine);
  outcome.values.emplace_back("seconds", seconds);
}

FeatureOutcome ridges_and_valleys(const CanonicalMesh& canonical, const Request& request,
                                  const ProgressCallback& progress)
{
  const RidgeValleyParameters& p = request.ridge_valley;
  if (!p.ridges && !p.valleys) throw ParameterError("Nothing is asked for: set 'ridges' or 'valleys' to true.");
  Measured measured(canonical, request, progress);
  measured.execution.begin_stage("ridges and valleys", 100);
  const RidgeValleyRegions found = find_ridges_and_valleys(measured.surface, measured.result, p, measured.execution);

  FeatureOutcome outcome;
  outcome.selection = canonical.for_caller(found.region);
  NamedValues kind{"ii_feature", {}};
  int ridges = 0, valleys = 0, vertices = 0;
  for (const FeatureKind k : canonical.for_caller(found.kind)) {
    kind.values.push_back(float(k));
    vertices += k != FeatureKind::none;
    if (request.output.colorize)
      outcome.colors.push_back(k == FeatureKind::ridge    ? first_color
                               : k == FeatureKind::valley ? second_color
                                                          : neutral);
  }
  for (const FeatureRegion& region : found.regions) ++(region.kind == FeatureKind::ridge ? ridges : valleys);
  outcome.attributes.push_back(std::move(kind));
  outcome.values = {{"ridges", ridges},
                    {"valleys", valleys},
                    {"selected_vertices", vertices},
                    {"high_threshold", found.high},
                    {"low_threshold", found.low}};
  add_log(measured, "Ridges and valleys by curvature",
          {"Thresholds: " + short_number(found.high) + " and " + short_number(found.low) + " 1/length",
           "Found: " + std::to_string(ridges) + " ridges and " + std::to_string(valleys) + " valleys, " +
               std::to_string(vertices) + " vertices"},
          outcome);
  return outcome;
}

FeatureOutcome crest_lines(const CanonicalMesh& canonical, const Request& request, const ProgressCallback& progress)
{
  if (!request.crest.ridges && !request.crest.valleys)
    throw ParameterError("Nothing is asked for: set 'ridges' or 'valleys' to true.");
  Measured measured(canonical, request, progress);
  measured.execution.begin_stage("crest lines", 100);
  const std::vector<CrestLine> lines =
      find_crest_lines(measured.surface, curvature_field(measured.result), request.crest, measured.execution);

  FeatureOutcome outcome;
  outcome.lines = crest_layer(canonical.mesh, measured.result, lines, {request.output.colorize, request.layer.lift});
  double ridge_length = 0, valley_length = 0;
  for (const CrestLine& line : lines) (line.kind == FeatureKind::ridge ? ridge_length : valley_length) += line.length;
  outcome.values = {{"lines", int(lines.size())},
                    {"ridge_length", ridge_length},
                    {"valley_length", valley_length},
                    {"largest_strength", lines.empty() ? 0 : lines.front().strength}};
  add_log(measured, "Crest lines",
          {"Found: " + std::to_string(lines.size()) + " lines; ridges " + short_number(ridge_length) + ", valleys " +
           short_number(valley_length) + " long together" +
           (lines.empty() ? "; lower minimum_strength, minimum_length or minimum_sharpness for more" : "")},
          outcome);
  return outcome;
}

FeatureOutcome principal_directions(const CanonicalMesh& canonical, const Request& request,
                                    const ProgressCallback& progress)
{
  DirectionParameters p = request.direction;
  p.memory_limit_mb = request.method.memory_limit_mb;
  if (!p.maximal && !p.minimal) throw ParameterError("Nothing is asked for: set 'maximal' or 'minimal' to true.");
  Measured measured(canonical, request, progress);
  measured.execution.begin_stage("directions", 100);
  const CurvatureField field = curvature_field(measured.result);
  const LineStyle style{request.output.colorize, request.layer.lift};

  FeatureOutcome outcome;
  std::string found;
  if (request.layer.style == DirectionStyle::segments) {
    const auto segments = direction_segments(measured.surface, field, p, measured.execution);
    outcome.lines = segment_layer(canonical.mesh, measured.result, segments, style);
    outcome.values = {{"lines", int(segments.size())}};
    found = "Drawn: " + std::to_string(segments.size()) + " segments";
  } else {
    const auto lines = trace_curvature_lines(measured.surface, field, p, measured.execution);
    double length = 0;
    int closed = 0;
    for (const CurvatureLine& line : lines) {
      length += line.length;
      closed += line.closed;
    }
    outcome.lines = curvature_line_layer(canonical.mesh, measured.result, lines, style);
    outcome.values = {{"lines", int(lines.size())}, {"closed_lines", closed}, {"length", length}};
    found = "Traced: " + std::to_string(lines.size()) + " lines, " + std::to_string(closed) + " of them closed, " +
            short_number(length) + " long together";
  }
  add_log(measured, "Principal directions", {found}, outcome);
  return outcome;
}

/// The attributes ii_volume_1, ii_mean_1, ... of a signature.
std::vector<NamedValues> signature_attributes(const Signature& signature)
{
  const char* const names[signature_quantity_count] = {"ii_volume_", "ii_mean_", "ii_difference_"};
  std::vector<NamedValues> attributes;
  for (int q = 0; q < signature_quantity_count; ++q)
    for (std::size_t s = 0; s < signature.radii.size(); ++s)
      attributes.push_back({names[q] + std::to_string(s + 1), signature.values[q][s]});
  return attributes;
}

FeatureOutcome signature(const TriangleMesh& mesh, const Request& request, const ProgressCallback& progress)
{
  const ReductionParameters& p = request.signature;
  if (p.reduction == Reduction::one_scale && p.scale > request.method.scales)
    throw ParameterError("The parameter 'scale' is " + std::to_string(p.scale) + ", but there are " +
                         std::to_string(request.method.scales) + " scales (parameter 'scales').");
  const Signature computed = compute_signature(mesh, request.method, progress);

  FeatureOutcome outcome;
  outcome.quality = reduce(computed, p);
  // Signs mean something but for differences and norms, whose colours are those of a magnitude.
  const bool magnitude = p.quantity == SignatureQuantity::difference || p.reduction == Reduction::p_norm;
  const Quantity like = magnitude ? Quantity::curvedness : Quantity::mean;
  const ColorRange range = color_range(outcome.quality, like, request.output.color_percentile);
  if (request.output.colorize)
    for (const double value : outcome.quality) outcome.colors.push_back(color_of(value, range, like));
  outcome.attributes = signature_attributes(computed);

  Result run;
  run.surface = computed.surface;
  run.scales = computed.radii;
  run.average_edge = computed.average_edge;
  run.diagonal = computed.diagonal;
  run.engine = computed.engine;
  run.stages = computed.stages;
  const Statistics s = statistics(outcome.quality);
  outcome.log = run_lines(run);
  outcome.log.insert(outcome.log.begin(), "Multi-scale signature");
  outcome.log.push_back("Quality: from " + short_number(s.minimum) + " to " + short_number(s.maximum) + "; 5% " +
                        short_number(s.p5) + ", median " + short_number(s.median) + ", 95% " + short_number(s.p95));
  outcome.log.push_back(time_line(run));
  outcome.values = {{"scales", int(run.scales.size())}, {"quality_min", s.minimum}, {"quality_p5", s.p5},
                    {"quality_median", s.median},       {"quality_p95", s.p95},     {"quality_max", s.maximum},
                    {"average_edge", run.average_edge}, {"engine", run.engine}};
  return outcome;
}

}  // namespace

FeatureOutcome compute_feature(FilterId filter, const TriangleMesh& mesh, const Request& request,
                               const ProgressCallback& progress)
{
  for (const char* name : {"lift", "color_percentile"}) require_permitted(name, request, filter);
  switch (filter) {
    case FilterId::ridges_and_valleys:
      return ridges_and_valleys(canonical_mesh(mesh, request, progress), request, progress);
    case FilterId::crest_lines:
      return crest_lines(canonical_mesh(mesh, request, progress), request, progress);
    case FilterId::principal_directions:
      return principal_directions(canonical_mesh(mesh, request, progress), request, progress);
    case FilterId::signature:
      return signature(mesh, request, progress);  // no stage of it depends on the order
    case FilterId::curvature:
      break;
  }
  throw ParameterError("The filter for curvatures leaves no features.");
}

}  // namespace integral_invariant::filter
