// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzzing: any mesh with any request through the filters: ridges and valleys, crest lines, direction lines, signature,
// and the curvature filter's quality and colours. Either refused in words, or finite throughout.
#include <algorithm>

#include "fuzz/invariants.h"
#include "fuzz/read_mesh.h"
#include "fuzz/read_parameters.h"
#include "integral_invariant/features/crest_lines.h"
#include "integral_invariant/features/curvature_lines.h"
#include "integral_invariant/features/ridges_valleys.h"
#include "integral_invariant/features/signature.h"
#include "registry.h"

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
Request read_request(fuzz::ByteReader& bytes, const Filter& filter)
{
  Request request;
  const std::vector<ParameterSpec>& rows = filter.parameters;
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
  double* const reals[] = {&r.part<RidgeValleyParameters>().high_percentile,
                           &r.part<RidgeValleyParameters>().low_percentile,
                           &r.part<RidgeValleyParameters>().high_curvature,
                           &r.part<RidgeValleyParameters>().low_curvature,
                           &r.part<RidgeValleyParameters>().minimum_area,
                           &r.part<CrestLineParameters>().minimum_strength,
                           &r.part<CrestLineParameters>().minimum_length,
                           &r.part<CrestLineParameters>().minimum_sharpness,
                           &r.part<DirectionParameters>().spacing,
                           &r.part<DirectionParameters>().segment_length,
                           &r.part<DirectionParameters>().minimum_length,
                           &r.part<DirectionParameters>().umbilic,
                           &r.part<ReductionParameters>().p};
  *reals[bytes.below(std::size(reals))] = bytes.any_real();
  int* const wholes[] = {&r.part<RidgeValleyParameters>().minimum_vertices,
                         &r.part<CrestLineParameters>().smoothing_passes,
                         &r.part<DirectionParameters>().smoothing_passes, &r.part<ReductionParameters>().scale};
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

void require_sound(const FilterResult& result, std::size_t vertices)
{
  fuzz::require(result.selection.empty() || result.selection.size() == vertices, "one region a vertex");
  fuzz::require(result.quality.empty() || result.quality.size() == vertices, "one quality a vertex");
  fuzz::require(result.colors.empty() || result.colors.size() == vertices, "one colour a vertex");
  fuzz::require_finite(result.quality, "quality is finite");
  for (const NamedValues& attribute : result.attributes) {
    fuzz::require(attribute.values.size() == vertices, "one attribute a vertex");
    fuzz::require_finite(attribute.values, "attributes are finite");
  }
  if (result.curvature) fuzz::require_sound(*result.curvature, vertices);
  if (result.lines) require_sound(*result.lines);
  fuzz::require(!result.log.empty(), "a run has a log");
  for (const std::string& line : result.log) fuzz::require(!line.empty(), "a line of the log says something");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::ByteReader bytes(data, size);
  const Filter& filter = *all_filters()[bytes.below(std::uint32_t(all_filters().size()))];
  Request request = read_request(bytes, filter);
  fuzz::keep_small(request.part<Parameters>());
  if (bytes.below(4) == 0) spoil(bytes, request);
  keep_short(request.part<CrestLineParameters>().smoothing_passes);
  keep_short(request.part<DirectionParameters>().smoothing_passes);
  const TriangleMesh mesh = fuzz::read_mesh(bytes);
  try {
    require_sound(run_filter(filter, {mesh, request}), mesh.positions.size());
  } catch (const InputError& error) {
    fuzz::require_sentence(error);
  }
  return 0;
}
