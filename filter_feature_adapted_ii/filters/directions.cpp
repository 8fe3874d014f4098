// SPDX-License-Identifier: GPL-3.0-or-later
// Create Principal Direction Layer.
#include "curvature_source.h"
#include "integral_invariant/features/curvature_lines.h"
#include "integral_invariant/parameters.h"
#include "line_layer.h"
#include "registry.h"
#include "report.h"

namespace integral_invariant::filter {

namespace {

using D = DirectionParameters;

enum class DirectionStyle { traced = 0, segments = 1 };

struct DirectionOptions {
  DirectionStyle style = DirectionStyle::traced;
};

constexpr const char* help = R"(Makes a new layer that shows the <b>principal directions</b>: evenly spaced lines of
curvature over the surface, or short segments at vertices. The directions are those of
<i>Compute Curvature by Integral Invariants per Vertex</i>. Lines end at umbilics (where the surface bends alike in all
directions), at boundaries, and where they come too near to another line; closed ones are joined.<br/>
Attributes of the new layer: ii_line (number of the line), ii_kind (1 maximal, -1 minimal curvature), ii_strength (the
curvature along the line). To keep the edges in a file, name one in export_file.)";

std::vector<ParameterSpec> parameters()
{
  return concatenate(
      {
          choice<&DirectionOptions::style>(
              "style", {"Lines of curvature", "Segments"},
              {"Style",
               "Lines of curvature: evenly spaced curves along the directions, which end at "
               "umbilics. Segments: short lines "
               "at vertices."}),
          boolean<&D::maximal>("maximal", {"Maximal curvature", "Directions of the maximal curvature."}),
          boolean<&D::minimal>("minimal", {"Minimal curvature", "Directions of the minimal curvature."}),
          length<&D::spacing>(
              "spacing",
              {"Spacing", "Distance between neighbouring lines, or between segments. 0: three average edge lengths."}),
          length<&D::segment_length>("segment_length", {"Length of segments", "0: eight tenths of the spacing."}),
          length<&D::minimum_length>(
              "minimum_length",
              {"Least length of lines", "Shorter lines of curvature are dropped. 0: twice the spacing."}),
          real<&D::umbilic>("umbilic", "", {0, 1},
                            {"Umbilic threshold",
                             "Lines end, and segments are left out, where the difference of the principal curvatures "
                             "is under this part of "
                             "their size: there is no direction there."}),
          integer<&D::smoothing_passes>("field_smoothing_passes", "", {0, most_passes},
                                        {"Smoothing of the curvatures",
                                         "How often curvatures are averaged over the mesh before lines are traced."}),
          boolean<&OutputOptions::colorize>("colorize",
                                            {"Colour the lines", "Maximal curvature red, minimal curvature blue."}),
          line_lift_parameter(),
          line_export_parameter(),
      },
      curvature_source_parameters());
}

/// Draws segments at vertices. \return what was drawn, for the log
std::string draw_segments(MeasuredMesh& measured, const D& p, const LineStyle& style, FilterResult& result)
{
  const CurvatureField field = curvature_field(measured.curvature);
  const auto segments = direction_segments(measured.surface, field, p, measured.execution);
  result.lines = segment_layer(measured.canonical.mesh, measured.curvature, segments, style);
  result.values = {{"lines", int(segments.size())}};
  return "Drawn: " + std::to_string(segments.size()) + " segments";
}

/// Traces lines of curvature. \return what was traced, for the log
std::string trace_lines(MeasuredMesh& measured, const D& p, const LineStyle& style, FilterResult& result)
{
  const CurvatureField field = curvature_field(measured.curvature);
  const auto lines = trace_curvature_lines(measured.surface, field, p, measured.execution);
  double length = 0;
  int closed = 0;
  for (const CurvatureLine& line : lines) {
    length += line.length;
    closed += line.closed;
  }
  result.lines = curvature_line_layer(measured.canonical.mesh, measured.curvature, lines, style);
  result.values = {{"lines", int(lines.size())}, {"closed_lines", closed}, {"length", length}};
  return "Traced: " + std::to_string(lines.size()) + " lines, " + std::to_string(closed) + " of them closed, " +
         short_number(length) + " long together";
}

FilterResult run(const FilterInput& input, const ProgressCallback& progress)
{
  D p = input.request.part<D>();
  p.memory_limit_mb = input.request.part<Parameters>().memory_limit_mb;
  if (!p.maximal && !p.minimal) throw ParameterError("Nothing is asked for: set 'maximal' or 'minimal' to true.");
  MeasuredMesh measured(input, progress);
  measured.execution.begin_stage("directions", 100);

  FilterResult result;
  const bool segments = input.request.part<DirectionOptions>().style == DirectionStyle::segments;
  const auto draw = segments ? draw_segments : trace_lines;
  const std::string drawn = draw(measured, p, line_style(input.request), result);
  add_report(measured, "Principal directions", {drawn}, result);
  return result;
}

}  // namespace

const Filter& directions_filter()
{
  static const Filter filter{"Create Principal Direction Layer",
                             "create_principal_direction_layer",
                             help,
                             menu_layers | menu_normals_and_curvature,
                             0,
                             parameters(),
                             run};
  return filter;
}

}  // namespace integral_invariant::filter
