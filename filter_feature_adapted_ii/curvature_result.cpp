// SPDX-License-Identifier: GPL-3.0-or-later
// Quality, colours and summary of curvatures.
#include "curvature_result.h"

#include "report.h"

namespace integral_invariant::filter {

namespace {

using Values = std::vector<std::pair<std::string, SummaryValue>>;

void add_quality(const OutputOptions& options, FilterResult& result)
{
  const Quantity quantity = options.quality;
  result.quality = quantity_values(*result.curvature, quantity);
  const ColorRange range = color_range(result.quality, quantity, options.color_percentile);
  const std::string unit = quantity_unit(quantity);
  const std::string label = quantity_label(quantity) + std::string(" ") + (unit.empty() ? "" : "in " + unit + " ");
  result.log.push_back(quality_line(label, statistics(result.quality)));
  if (!options.colorize) return;
  result.colors.reserve(result.quality.size());
  for (const double value : result.quality) result.colors.push_back(color_of(value, range, quantity));
  result.log.push_back("Colours: from " + short_number(range.low) + " to " + short_number(range.high));
}

Values run_values(const Result& result)
{
  const auto count = [](std::size_t number) { return static_cast<int>(number); };
  return {
      {"vertices", count(result.surface.vertices)},
      {"triangles", count(result.surface.triangles)},
      {"scales", count(result.scales.size())},
      {"smallest_radius", result.scales.empty() ? 0 : result.scales.front()},
      {"largest_radius", result.scales.empty() ? 0 : result.scales.back()},
      {"average_edge", result.average_edge},
      {"median_radius", statistics(result.radius).median},
      {"converged", count(result.converged)},
      {"mean_iterations", result.mean_iterations},
      {"low_confidence", count(low_confidence_count(result))},
      {"joined_vertices", count(result.surface.joined_vertices)},
      {"boundary_edges", count(result.surface.boundary_edges)},
      {"seconds", total_seconds(result)},
      {"engine", result.engine},
  };
}

void add_quantity_values(const Result& result, Values& values)
{
  for (int i = 0; i < quantity_count; ++i) {
    const auto quantity = static_cast<Quantity>(i);
    const Statistics s = statistics(quantity_values(result, quantity));
    const std::string key = quantity_key(quantity);
    const std::pair<const char*, double> entries[] = {
        {"_min", s.minimum}, {"_p5", s.p5}, {"_median", s.median}, {"_p95", s.p95}, {"_max", s.maximum}};
    for (const auto& [suffix, value] : entries) values.emplace_back(key + suffix, value);
  }
}

}  // namespace

FilterResult curvature_result(Result curvature, const OutputOptions& options)
{
  FilterResult result;
  result.curvature = std::move(curvature);
  result.log = run_lines(*result.curvature);
  result.log.insert(result.log.begin(), "Curvature by integral invariants");
  add_quality(options, result);
  const std::vector<std::string> defects = defect_lines(*result.curvature);
  result.log.insert(result.log.end(), defects.begin(), defects.end());
  result.log.push_back(time_line(*result.curvature));
  result.values = run_values(*result.curvature);
  add_quantity_values(*result.curvature, result.values);
  return result;
}

}  // namespace integral_invariant::filter
