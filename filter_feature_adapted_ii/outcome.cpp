// SPDX-License-Identifier: GPL-3.0-or-later
// What a run leaves, and the summary of it for people and for programs.
#include "outcome.h"

#include <algorithm>
#include <cstdio>

namespace integral_invariant::filter {

std::string short_number(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

namespace {

constexpr float low_confidence = 0.5F;

std::string seconds_text(double seconds)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.2f s", seconds);
  return text;
}

std::string list(const std::vector<double>& values, double factor)
{
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + short_number(value * factor);
  return text;
}

double total_seconds(const Result& result)
{
  double sum = 0;
  for (const StageTime& stage : result.stages) sum += stage.seconds;
  return sum;
}

std::string surface_line(const Result& result)
{
  return "Mesh: " + std::to_string(result.surface.vertices) + " vertices, " + std::to_string(result.surface.triangles) +
         " triangles, average edge " + short_number(result.average_edge) + ", diagonal " +
         short_number(result.diagonal);
}

void add_scale_lines(const Result& result, std::vector<std::string>& lines)
{
  lines.push_back("Scales: " + std::to_string(result.scales.size()) + ", radii " + list(result.scales, 1));
  lines.push_back("  in average edge lengths: " + list(result.scales, 1 / result.average_edge));
  lines.push_back("  in % of the diagonal: " + list(result.scales, 100 / result.diagonal));
}

std::string convergence_line(const Result& result)
{
  if (result.scales.size() == 1) return "Radius: fixed";
  const Statistics radius = statistics(result.radius);
  return "Radius: " + short_number(radius.minimum) + " to " + short_number(radius.maximum) + ", median " +
         short_number(radius.median) + "; " + std::to_string(result.converged) + " of " +
         std::to_string(result.radius.size() - result.surface.joined_vertices) + " vertices converged, " +
         short_number(result.mean_iterations) + " iterations on average, " + std::to_string(result.largest_iterations) +
         " at most";
}

void add_quality_lines(const Outcome& outcome, std::vector<std::string>& lines)
{
  const Statistics& s = outcome.quality_statistics;
  const std::string unit = quantity_unit(outcome.quantity);
  lines.push_back(std::string("Quality: ") + quantity_label(outcome.quantity) + (unit.empty() ? "" : " in " + unit) +
                  " from " + short_number(s.minimum) + " to " + short_number(s.maximum) + "; 5% " + short_number(s.p5) +
                  ", median " + short_number(s.median) + ", 95% " + short_number(s.p95));
  if (outcome.colorize)
    lines.push_back("Colours: from " + short_number(outcome.colors.low) + " to " + short_number(outcome.colors.high));
}

/// What is wrong with the mesh, only where something is.
void add_defect_line(const Result& result, std::vector<std::string>& lines)
{
  const SurfaceReport& report = result.surface;
  const std::pair<std::size_t, const char*> counts[] = {
      {report.joined_vertices, "vertices joined with another at the same place"},
      {report.boundary_edges, "boundary edges"},
      {report.inconsistent_edges, "edges with inconsistently oriented triangles"},
      {report.duplicate_triangles, "duplicate triangles"},
      {report.zero_area_triangles, "triangles without area"},
      {report.left_out_triangles, "triangles left out (a vertex twice, or not finite)"},
      {report.unreferenced_vertices, "vertices without a triangle"},
      {report.nonfinite_vertices, "vertices that are not finite"},
      {low_confidence_count(result), "vertices with little of their ball's surface (ii_confidence under 0.5)"},
  };
  std::string text;
  for (const auto& [count, noun] : counts)
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + noun;
  // From here on rounding shows beside a sensor's noise.
  constexpr double notable_step = 0.02;  // average edges
  if (report.coordinate_step > notable_step * result.average_edge)
    text += std::string(text.empty() ? "" : ", ") + "coordinates in steps of " +
            short_number(report.coordinate_step / result.average_edge) +
            " average edges, because the mesh lies far from the origin: move it there before it is stored";
  if (report.inside_out)
    text += std::string(text.empty() ? "" : ", ") + "inside out: taken as if all triangles were flipped";
  if (!text.empty()) lines.push_back("Note: " + text);
}

}  // namespace

std::string time_line(const Result& result)
{
  std::string text = "Time: " + seconds_text(total_seconds(result));
  const char* separator = " (";
  for (const StageTime& stage : result.stages) {
    text += separator + stage.stage + " " + seconds_text(stage.seconds);
    separator = ", ";
  }
  return result.stages.empty() ? text : text + ")";
}

std::vector<std::string> run_lines(const Result& result)
{
  std::vector<std::string> lines{surface_line(result)};
  add_scale_lines(result, lines);
  lines.push_back("Engine: " + result.engine);
  if (!result.radius.empty()) lines.push_back(convergence_line(result));
  add_defect_line(result, lines);
  return lines;
}

Outcome make_outcome(Result result, const OutputOptions& options)
{
  Outcome outcome;
  outcome.quantity = options.quality;
  outcome.quality = quantity_values(result, options.quality);
  outcome.quality_statistics = statistics(outcome.quality);
  outcome.colorize = options.colorize;
  outcome.colors = color_range(outcome.quality, options.quality, options.color_percentile);
  outcome.result = std::move(result);
  return outcome;
}

std::size_t low_confidence_count(const Result& result)
{
  return static_cast<std::size_t>(std::count_if(result.confidence.begin(), result.confidence.end(),
                                                [](float confidence) { return confidence < low_confidence; }));
}

std::vector<std::string> summary_lines(const Outcome& outcome)
{
  const Result& result = outcome.result;
  std::vector<std::string> lines{"Curvature by integral invariants", surface_line(result)};
  add_scale_lines(result, lines);
  lines.push_back("Engine: " + result.engine);
  lines.push_back(convergence_line(result));
  add_quality_lines(outcome, lines);
  add_defect_line(result, lines);
  if (!outcome.exported.empty()) lines.push_back("Exported: " + outcome.exported);
  lines.push_back(time_line(result));
  return lines;
}

std::vector<std::pair<std::string, SummaryValue>> summary_values(const Outcome& outcome)
{
  const Result& result = outcome.result;
  const auto count = [](std::size_t number) { return static_cast<int>(number); };
  std::vector<std::pair<std::string, SummaryValue>> values{
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
      {"exported", outcome.exported},
  };
  for (int i = 0; i < quantity_count; ++i) {
    const auto quantity = static_cast<Quantity>(i);
    const Statistics s = statistics(quantity_values(result, quantity));
    const std::string key = quantity_key(quantity);
    const std::pair<const char*, double> entries[] = {
        {"_min", s.minimum}, {"_p5", s.p5}, {"_median", s.median}, {"_p95", s.p95}, {"_max", s.maximum}};
    for (const auto& [suffix, value] : entries) values.emplace_back(key + suffix, value);
  }
  return values;
}

}  // namespace integral_invariant::filter
