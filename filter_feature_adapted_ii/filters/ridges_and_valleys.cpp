// SPDX-License-Identifier: GPL-3.0-or-later
// Select Ridges and Valleys by Curvature.
#include "curvature_source.h"
#include "integral_invariant/features/ridges_valleys.h"
#include "line_layer.h"
#include "registry.h"
#include "report.h"

namespace integral_invariant::filter {

namespace {

using R = RidgeValleyParameters;

constexpr const char* help = R"(Selects the regions of the surface that bend strongly: <b>ridges</b>, where the
maximal curvature is large and positive, and <b>valleys</b>, where the minimal curvature is large and negative. The curvatures
are those of <i>Compute Curvature by Integral Invariants per Vertex</i>, so noise does not break the regions up.<br/>
With two thresholds a region grows, over connected vertices above the low one, from vertices above the high one; small regions
are dropped. Selects vertices and faces, and writes the vertex attribute ii_feature (1 ridge, -1 valley, 0 neither).<br/>
See: <i>Y.-K. Lai, S.-M. Hu, T. Fang</i>, <b>"Robust Principal Curvatures using Feature Adapted Integral Invariants"</b>,
<a href="https://doi.org/10.1145/1629255.1629298">SPM 2009</a>, section 5.)";

constexpr double largest_real = 1e30;  // hosts keep numbers in single precision

std::vector<ParameterSpec> parameters()
{
  return concatenate(
      {
          boolean<&R::ridges>("ridges",
                              {"Ridges", "Select regions with a large positive maximal curvature.", "[Lai09] 5"}),
          boolean<&R::valleys>("valleys",
                               {"Valleys", "Select regions with a large negative minimal curvature.", "[Lai09] 5"}),
          choice<&R::threshold>("threshold", {"Percentile", "Curvature"},
                                {"Thresholds",
                                 "Percentile: relative to the largest absolute curvature of all vertices. Curvature: "
                                 "absolute, 1/length."}),
          real<&R::high_percentile>("high_percentile", "%", {0, 100},
                                    {"High threshold (percentile)",
                                     "A region needs a vertex that is stronger than this part of all vertices."}),
          real<&R::low_percentile>(
              "low_percentile", "%", {0, 100},
              {"Low threshold (percentile)",
               "A region grows over connected vertices that are stronger than this part of all vertices."}),
          real<&R::high_curvature>("high_curvature", "1/length", {0, largest_real},
                                   {"High threshold (curvature)",
                                    "The same as an absolute curvature; used when thresholds are curvatures."}),
          real<&R::low_curvature>(
              "low_curvature", "1/length", {0, largest_real},
              {"Low threshold (curvature)", "The same as an absolute curvature; 0: half of the high one."}),
          integer<&R::minimum_vertices>("minimum_vertices", "", {0, largest_int},
                                        {"Least vertices of a region", "Smaller regions are dropped."}),
          real<&R::minimum_area>("minimum_area", "length^2", {0, largest_real},
                                 {"Least area of a region", "Smaller regions are dropped."}),
          boolean<&OutputOptions::colorize>("colorize",
                                            {"Colour the vertices", "Ridges red, valleys blue, the rest grey."}),
          save_file<&OutputOptions::export_file>(
              "export_file", {"Export to PLY",
                              "Writes the mesh with the property ii_feature (1 ridge, -1 valley, 0 neither) and "
                              "colours. Empty: no file."}),
      },
      curvature_source_parameters());
}

constexpr Color neutral{208, 208, 208};

Color color_of_kind(FeatureKind kind)
{
  if (kind == FeatureKind::none) return neutral;
  return kind == FeatureKind::ridge ? first_color : second_color;
}

FilterResult run(const FilterInput& input, const ProgressCallback& progress)
{
  const auto& p = input.request.part<RidgeValleyParameters>();
  if (!p.ridges && !p.valleys) throw ParameterError("Nothing is asked for: set 'ridges' or 'valleys' to true.");
  MeasuredMesh measured(input, progress);
  measured.execution.begin_stage("ridges and valleys", 100);
  const RidgeValleyRegions found = find_ridges_and_valleys(measured.surface, measured.curvature, p, measured.execution);

  FilterResult result;
  result.selection = measured.canonical.for_caller(found.region);
  NamedValues kinds{"ii_feature", {}};
  int ridges = 0, valleys = 0, vertices = 0;
  for (const FeatureKind kind : measured.canonical.for_caller(found.kind)) {
    kinds.values.push_back(float(kind));
    vertices += kind != FeatureKind::none;
    if (input.request.part<OutputOptions>().colorize) result.colors.push_back(color_of_kind(kind));
  }
  for (const FeatureRegion& region : found.regions) ++(region.kind == FeatureKind::ridge ? ridges : valleys);
  result.attributes.push_back(std::move(kinds));
  result.values = {{"ridges", ridges},
                   {"valleys", valleys},
                   {"selected_vertices", vertices},
                   {"high_threshold", found.high},
                   {"low_threshold", found.low}};
  add_report(measured, "Ridges and valleys by curvature",
             {"Thresholds: " + short_number(found.high) + " and " + short_number(found.low) + " 1/length",
              "Found: " + std::to_string(ridges) + " ridges and " + std::to_string(valleys) + " valleys, " +
                  std::to_string(vertices) + " vertices"},
             result);
  return result;
}

}  // namespace

const Filter& ridges_and_valleys_filter()
{
  static const Filter filter{"Select Ridges and Valleys by Curvature",
                             "select_ridges_and_valleys_by_curvature",
                             help,
                             menu_selection | menu_vertex_colors,
                             field_selection | field_color,
                             parameters(),
                             run};
  return filter;
}

}  // namespace integral_invariant::filter
