// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzzing: any mesh with any request through the filters: ridges and valleys, crest lines, direction lines, signature,
// and the curvature filter's quality and colours. Either refused in words, or finite throughout.
#include <algorithm>

#include "feature_outcome.h"
#include "filters.h"
#include "fuzz/invariants.h"
#include "fuzz/read_mesh.h"
#include "fuzz/read_parameters.h"
#include "integral_invariant/curvature.h"

namespace {

using namespace integral_invariant;
using namespace integral_invariant::filter;

double read_value(fuzz::ByteReader& bytes, const ParameterSpec& spec)
{
  const std::uint32_t choice = bytes.below(8);
  if (choice == 0) return bytes.any_real();
  if (spec.kind == Kind::integer || spec.kind == Kind::choice || spec.kind == Kind::boolean)
    return double(bytes.below(12));
  if (spec.kind == Kind::length && choice < 3) return bytes.magnitude();
  return bytes.between(std::max(spec.minimum, -10.0), std::min(spec.maximum, 10.0));
}

/// Values as hosts hand them over, in the order of the bytes; what a row refuses keeps its default.
Request read_request(fuzz::ByteReader& bytes, FilterId filter)
{
  Request request;
  const std::vector<ParameterSpec>& rows = parameter_table(filter);
  for (std::uint32_t i = bytes.below(20); i > 0; --i) {
    const ParameterSpec& spec = rows[bytes.below(std::uint32_t(rows.size()))];
    if (spec.kind == Kind::save_file) continue;
    try {
      store(spec, read_value(bytes, spec), request);
    } catch (const ParameterError& error) {
      fuzz::require_sentence(error);
    }
  }
  return request;
}

/// Fields that the C++ interface takes without a table.
void spoil(fuzz::ByteReader& bytes, Request& r)
{
  double* const reals[] = {&r.ridge_valley.high_percentile,
                           &r.ridge_valley.low_percentile,
                           &r.ridge_valley.high_curvature,
                           &r.ridge_valley.low_curvature,
                           &r.ridge_valley.minimum_area,
                           &r.crest.minimum_strength,
                           &r.crest.minimum_length,
                           &r.crest.minimum_sharpness,
                           &r.direction.spacing,
                           &r.direction.segment_length,
                           &r.direction.minimum_length,
                           &r.direction.umbilic,
                           &r.signature.p};
  *reals[bytes.below(std::size(reals))] = bytes.any_real();
  int* const wholes[] = {&r.ridge_valley.minimum_vertices, &r.crest.smoothing_passes, &r.direction.smoothing_passes,
                         &r.signature.scale};
  *wholes[bytes.below(std::size(wholes))] = bytes.any_int();
}

void keep_short(int& passes)
{
  if (passes > 20 && passes <= limits::max_smoothing_passes) passes = 20;
}

void require_sound(const LineLayer& lines)
{
  const std::size_t n = lines.positions.size();
  for (const Vec3& p : lines.positions) fuzz::require(is_finite(p), "lines have finite positions");
  for (const Vec3& normal : lines.normals) fuzz::require(is_finite(normal), "lines have finite normals");
  fuzz::require_finite(lines.quality, "lines have finite quality");
  fuzz::require(lines.normals.size() == n && lines.quality.size() == n, "one normal and quality a point");
  fuzz::require(lines.colors.empty() || lines.colors.size() == n, "one colour a point");
  for (const auto& edge : lines.edges)
    for (const std::int32_t v : edge) fuzz::require(v >= 0 && std::size_t(v) < n, "edges name points");
  for (const NamedValues& attribute : lines.attributes) {
    fuzz::require(attribute.values.size() == n, "one attribute a point");
    fuzz::require_finite(attribute.values, "attributes of lines are finite");
  }
}

void require_sound(const FeatureOutcome& outcome, std::size_t vertices)
{
  fuzz::require(outcome.selection.empty() || outcome.selection.size() == vertices, "one region a vertex");
  fuzz::require(outcome.quality.empty() || outcome.quality.size() == vertices, "one quality a vertex");
  fuzz::require(outcome.colors.empty() || outcome.colors.size() == vertices, "one colour a vertex");
  fuzz::require_finite(outcome.quality, "quality is finite");
  for (const NamedValues& attribute : outcome.attributes) {
    fuzz::require(attribute.values.size() == vertices, "one attribute a vertex");
    fuzz::require_finite(attribute.values, "attributes are finite");
  }
  if (outcome.lines) require_sound(*outcome.lines);
  for (const std::string& line : outcome.log) fuzz::require(!line.empty(), "a line of the log says something");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::ByteReader bytes(data, size);
  const auto filter = static_cast<FilterId>(bytes.below(filter_count));
  Request request = read_request(bytes, filter);
  fuzz::keep_small(request.method);
  if (bytes.below(4) == 0) spoil(bytes, request);
  keep_short(request.crest.smoothing_passes);
  keep_short(request.direction.smoothing_passes);
  const TriangleMesh mesh = fuzz::read_mesh(bytes);
  try {
    if (filter == FilterId::curvature) {
      const Outcome outcome = make_outcome(compute_curvature(mesh, request.method, {}), request.output);
      fuzz::require_sound(outcome.result, mesh.positions.size());
      fuzz::require_finite(outcome.quality, "quality is finite");
      fuzz::require(!summary_lines(outcome).empty(), "a run has a summary");
    } else {
      require_sound(compute_feature(filter, mesh, request, {}), mesh.positions.size());
    }
  } catch (const InputError& error) {
    fuzz::require_sentence(error);
  }
  return 0;
}
