// SPDX-License-Identifier: GPL-3.0-or-later
// Compute Curvature by Integral Invariants per Vertex.
#include "curvature_result.h"
#include "integral_invariant/parameters.h"
#include "integral_invariant/curvature.h"
#include "method_parameters.h"
#include "registry.h"

namespace integral_invariant::filter {

namespace {

constexpr const char* help =
    R"(Principal curvatures and directions by <b>integrals instead of derivatives</b>: from the
covariance of the part of the solid inside a ball around each vertex. Integrals average noise away; the radius of the ball says
which detail counts. A <b>statistical</b> radius (the default) measures at balls of all sizes, weighs each by what it shows over
the mesh's own noise, removes the bias of large balls, and gives the standard error ii_error.<br/>
The published <b>feature-adapted</b> radius (with the published estimator): from the median over the scales, the radius <i>r</i>
of each vertex moves step by step towards alpha / max(|k<sub>max</sub>|, |k<sub>min</sub>|), and is then smoothed over the surface.
k<sub>max</sub> = 6/(&pi;r<sup>6</sup>) (&lambda;<sub>1</sub> &minus; 3&lambda;<sub>2</sub>) + 8/(5r), &lambda;<sub>1</sub> &ge;
&lambda;<sub>2</sub> the tangential eigenvalues of the covariance; exchange them for k<sub>min</sub>. <b>Signs:</b> k<sub>max</sub>
&ge; k<sub>min</sub> in 1/length, positive where the solid is convex; faces point outward.<br/>
See: <i>Lai, Hu, Fang</i>, <b>"Robust Principal Curvatures using Feature Adapted Integral Invariants"</b>,
<a href="https://doi.org/10.1145/1629255.1629298">GPM 2009</a>;
<i>Yang, Lai, Hu, Pottmann</i>, <b>"Robust Principal Curvatures on Multiple Scales"</b>,
<a href="https://doi.org/10.2312/SGP/SGP06/223-226">SGP 2006</a>;
<i>Pottmann, Wallner, Yang, Lai, Hu</i>, <b>"Principal curvatures from the integral invariant viewpoint"</b>,
<a href="https://doi.org/10.1016/j.cagd.2007.07.004">CAGD 24, 2007</a>.)";

std::vector<ParameterSpec> output_parameters()
{
  return {
      choice<&OutputOptions::quality>(
          "quality",
          {"Mean curvature", "Gaussian curvature", "Maximal curvature", "Minimal curvature", "Shape index",
           "Curvedness", "Radius", "Largest absolute curvature"},
          {"Quality",
           "What is written into the quality of the vertices. Curvature is positive where the solid is "
           "convex. The shape "
           "index runs from -1 (cup) over 0 (saddle, flat) to 1 (cap)."}),
      boolean<&OutputOptions::colorize>(
          "colorize",
          {"Colour the vertices",
           "Signed quantities: blue for negative, white for zero, red for positive. The others: from dark blue (small) "
           "over green to yellow (large)."}),
      color_percentile_parameter(),
      save_file<&OutputOptions::export_file>(
          "export_file",
          {"Export to PLY",
           "Writes the mesh with every output as a property of its vertices (ii_kmax, ii_kmin, ii_radius, "
           "ii_confidence, "
           "ii_dirmax_x, ... , quality, colour), because MeshLab saves no curvature directions. Empty: no file."}),
  };
}

std::vector<ParameterSpec> parameters()
{
  return concatenate(concatenate(method_parameters(), output_parameters()), detail_parameters());
}

FilterResult run(const FilterInput& input, const ProgressCallback& progress)
{
  return curvature_result(compute_curvature(input.mesh, input.request.part<Parameters>(), progress),
                          input.request.part<OutputOptions>());
}

}  // namespace

const Filter& curvature_filter()
{
  static const Filter filter{"Compute Curvature by Integral Invariants per Vertex",
                             "compute_curvature_by_integral_invariants_per_vertex",
                             help,
                             menu_normals_and_curvature | menu_vertex_colors,
                             field_curvature | field_radius | field_quality | field_color,
                             parameters(),
                             run};
  return filter;
}

}  // namespace integral_invariant::filter
