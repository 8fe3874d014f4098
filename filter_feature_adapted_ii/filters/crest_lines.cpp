// SPDX-License-Identifier: GPL-3.0-or-later
// Create Crest Lines Layer.
#include "curvature_source.h"
#include "integral_invariant/features/crest_lines.h"
#include "line_layer.h"
#include "registry.h"
#include "report.h"

namespace integral_invariant::filter {

namespace {

using C = CrestLineParameters;

constexpr const char* help = R"(Makes a new layer of <b>crest lines</b> as edges: ridge lines, along which the maximal
curvature is largest across the line, and valley lines, the same of the minimal curvature. They are found on the curvatures of
<i>Compute Curvature by Integral Invariants per Vertex</i>, as zeros of the derivative along the principal direction.<br/>
The quality of a line's vertices is its <b>strength</b>, the integral of the curvature along it: a number without unit, so the
same filter fits a model in any unit. Attributes of the new layer: ii_line (number of the line, strongest first), ii_kind
(1 ridge, -1 valley), ii_strength. To keep the edges in a file, name one in export_file.)";

std::vector<ParameterSpec> parameters()
{
  return concatenate(
      {
          boolean<&C::ridges>("ridges",
                              {"Ridge lines", "Lines where the maximal curvature is largest across the line."}),
          boolean<&C::valleys>("valleys",
                               {"Valley lines", "Lines where the minimal curvature is smallest across the line."}),
          real<&C::minimum_strength>("minimum_strength", "", {0, 1e6},
                                     {"Least strength",
                                      "The integral of the curvature along a line, which has no unit: 1 for a line as "
                                      "long as the radius that the "
                                      "surface bends with across it. Weaker lines are dropped."}),
          length<&C::minimum_length>("minimum_length",
                                     {"Least length", "Shorter lines are dropped. 0: five average edge lengths."}),
          real<&C::minimum_sharpness>("minimum_sharpness", "", {0, 100},
                                      {"Least sharpness",
                                       "How quickly the curvature falls beside a line, without unit: 0 for cylinders "
                                       "and spheres, up to 3 at the end of "
                                       "an ellipse. Less sharp lines are dropped."}),
          integer<&C::smoothing_passes>(
              "field_smoothing_passes", "", {0, most_passes},
              {"Smoothing of the curvatures",
               "How often curvatures are averaged over the mesh before lines are looked for."}),
          boolean<&OutputOptions::colorize>("colorize", {"Colour the lines", "Ridges red, valleys blue."}),
          line_lift_parameter(),
          line_export_parameter(),
      },
      curvature_source_parameters());
}

FilterResult run(const FilterInput& input, const ProgressCallback& progress)
{
  const auto& p = input.request.part<CrestLineParameters>();
  if (!p.ridges && !p.valleys) throw ParameterError("Nothing is asked for: set 'ridges' or 'valleys' to true.");
  MeasuredMesh measured(input, progress);
  measured.execution.begin_stage("crest lines", 100);
  const std::vector<CrestLine> lines =
      find_crest_lines(measured.surface, curvature_field(measured.curvature), p, measured.execution);

  FilterResult result;
  result.lines = crest_layer(measured.canonical.mesh, measured.curvature, lines, line_style(input.request));
  double ridge_length = 0, valley_length = 0;
  for (const CrestLine& line : lines) (line.kind == FeatureKind::ridge ? ridge_length : valley_length) += line.length;
  result.values = {{"lines", int(lines.size())},
                   {"ridge_length", ridge_length},
                   {"valley_length", valley_length},
                   {"largest_strength", lines.empty() ? 0 : lines.front().strength}};
  add_report(measured, "Crest lines",
             {"Found: " + std::to_string(lines.size()) + " lines; ridges " + short_number(ridge_length) + ", valleys " +
              short_number(valley_length) + " long together" +
              (lines.empty() ? "; lower minimum_strength, minimum_length or minimum_sharpness for more" : "")},
             result);
  return result;
}

}  // namespace

const Filter& crest_lines_filter()
{
  static const Filter filter{"Create Crest Lines Layer",
                             "create_crest_lines_layer",
                             help,
                             menu_layers | menu_normals_and_curvature,
                             0,
                             parameters(),
                             run};
  return filter;
}

}  // namespace integral_invariant::filter
