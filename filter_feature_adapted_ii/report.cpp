// SPDX-License-Identifier: GPL-3.0-or-later
// What a run tells people about itself.
#include "report.h"

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

}  // namespace

double total_seconds(const Result& result)
{
  double sum = 0;
  for (const StageTime& stage : result.stages) sum += stage.seconds;
  return sum;
}

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
  return lines;
}

std::vector<std::string> defect_lines(const Result& result)
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
  if (text.empty()) return {};
  return {"Note: " + text};
}

std::size_t low_confidence_count(const Result& result)
{
  return static_cast<std::size_t>(std::count_if(result.confidence.begin(), result.confidence.end(),
                                                [](float confidence) { return confidence < low_confidence; }));
}

std::string quality_line(const std::string& quantity, const Statistics& s)
{
  return "Quality: " + quantity + "from " + short_number(s.minimum) + " to " + short_number(s.maximum) + "; 5% " +
         short_number(s.p5) + ", median " + short_number(s.median) + ", 95% " + short_number(s.p95);
}

}  // namespace integral_invariant::filter
