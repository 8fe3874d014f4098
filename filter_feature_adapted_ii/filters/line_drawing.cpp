// SPDX-License-Identifier: GPL-3.0-or-later
// Create Line Drawing.
#include <map>

#include "curvature_source.h"
#include "drawing_layer.h"
#include "integral_invariant/drawing/paper_text.h"
#include "integral_invariant/drawing/sheet_writers.h"
#include "registry.h"
#include "report.h"

namespace integral_invariant::filter {

namespace {

using D = LineDrawingParameters;
using S = SheetParameters;

/// The sides as in the list of `view`, then these.
enum class ViewChoice { three_sides = side_count, six_sides, direction };

struct ViewOptions {
  int view = int(ViewChoice::six_sides);
  double toward_x = 0, toward_y = 0, toward_z = 1;
  double up_x = 0, up_y = 1, up_z = 0;
};

using V = ViewOptions;

constexpr const char* help =
    R"(Makes a <b>line drawing</b> of the surface: outlines, edges, and the lines at which shading
would change (suggestive contours, ridges and others), from the curvatures of <i>Compute Curvature by Integral Invariants per
Vertex</i>. A line is drawn where it is significant: its <b>z</b> says how many standard errors what makes it a line is away
from none, so that noise draws nothing and no threshold depends on the model.<br/>
The lines become a new layer of edges with the attributes ii_line, ii_kind, ii_z, ii_strength, ii_visible and ii_view. With
export_file, the views are laid out on a <b>sheet at true scale</b> with a scale bar and written as .svg, .pdf or .dxf, with a
layer for each view and kind of line; as .ply, the edges in space are written.)";

std::vector<ParameterSpec> view_parameters()
{
  const Range any{-1e6, 1e6};  // of a vector whose length does not matter
  return {
      choice<&V::view>(
          "view",
          {"Front", "Back", "Left", "Right", "Top", "Bottom", "Front, right side and top", "All six sides",
           "Direction below"},
          {"Views", "The sides are those of MeshLab's View menu: the front is seen along -z with y upwards."}),
      real<&V::toward_x>("toward_x", "", any,
                         {"Direction to the viewer, x", "Of a view of your own: from the model to the viewer."}),
      real<&V::toward_y>("toward_y", "", any, {"Direction to the viewer, y", "See x."}),
      real<&V::toward_z>("toward_z", "", any, {"Direction to the viewer, z", "See x."}),
      real<&V::up_x>("up_x", "", any, {"Up, x", "Of a view of your own: what points upwards in the picture."}),
      real<&V::up_y>("up_y", "", any, {"Up, y", "See x."}),
      real<&V::up_z>("up_z", "", any, {"Up, z", "See x."}),
  };
}

std::vector<ParameterSpec> kind_parameters()
{
  return {
      boolean<&D::contours>("contours", {"Contours", "The outline: where the surface turns away from the viewer."}),
      boolean<&D::boundaries>("boundaries", {"Boundaries", "The rims of open surfaces."}),
      boolean<&D::creases>("creases", {"Creases", "Edges of the mesh at which two triangles meet at an angle."}),
      boolean<&D::suggestive_contours>(
          "suggestive_contours",
          {"Suggestive contours", "Where the surface nearly turns away: contours of nearby views.", "DeCarlo 2003"}),
      boolean<&D::suggestive_highlights>(
          "suggestive_highlights",
          {"Suggestive highlights", "Where the surface nearly faces the viewer.", "DeCarlo 2007"}),
      boolean<&D::apparent_ridges>(
          "apparent_ridges", {"Apparent ridges", "Where the surface seems to bend most in this view.", "Judd 2007"}),
      boolean<&D::ridges>("ridges", {"Ridges", "Lines of largest convex curvature.", "Ohtake 2004"}),
      boolean<&D::valleys>("valleys", {"Valleys", "Lines of largest concave curvature.", "Ohtake 2004"}),
      boolean<&D::demarcating_curves>(
          "demarcating_curves",
          {"Demarcating curves", "Where relief passes from ridge to valley: inscriptions, scars.", "Kolomenkin 2008"}),
      boolean<&D::hatching>("hatching", {"Hatching", "Lines of curvature in the shade; light from the upper left."}),
      integer<&D::sections>("sections", "", {0, 1000},
                            {"Sections", "Number of parallel planes through the model whose cuts are drawn."}),
      choice<&D::section_axis>("section_axis", {"x", "y", "z"},
                               {"Axis of the sections", "The planes stand across it."}),
  };
}

std::vector<ParameterSpec> line_parameters()
{
  return {
      real<&D::significance>("significance", "standard errors", {0, 1e6},
                             {"Significance", "Mean z that a line must have. Higher: fewer and surer lines."}),
      length<&D::minimum_length>("minimum_length",
                                 {"Least length", "Shorter lines are dropped. 0: five average edge lengths."}),
      real<&D::crease_angle>("crease_angle", "degrees", {0, 180, true},
                             {"Least angle of creases", "Between the normals of the two triangles of an edge."}),
      length<&D::hatching_spacing>("hatching_spacing", {"Spacing of the hatching", "0: four average edge lengths."}),
      choice<&D::hidden>("hidden_lines", {"Not drawn", "Dashed"},
                         {"Hidden lines", "Dashed ones stand on a layer of their own for each view."}),
  };
}

std::vector<ParameterSpec> sheet_parameters()
{
  return {
      choice<&S::unit>("mesh_unit", {"Millimetre", "Centimetre", "Metre", "Inch"},
                       {"Unit of the mesh", "What 1 in the mesh's coordinates is, for the scale of the sheet."}),
      real<&S::scale>("sheet_scale", "", {0, 1e6},
                      {"Scale",
                       "Length on paper over true length: 1 for 1:1, 0.5 for 1:2. 0: the largest round one that "
                       "the paper has room for."}),
      choice<&S::paper>("paper", {"Fitted to the drawing", "A4", "A3"}, {"Paper", "Of the sheet."}),
      real<&S::outline_width>("outline_width", "mm", {0, 10, true}, {"Width of outlines", "Contours and boundaries."}),
      real<&S::inner_width>("inner_width", "mm", {0, 10, true},
                            {"Width of other lines", "Those of little significance are down to 0.6 of it."}),
      boolean<&OutputOptions::colorize>("colorize",
                                        {"Colour the layer", "Ridges red, valleys blue, other lines dark."}),
      line_lift_parameter(),
      save_file<&OutputOptions::export_file>(
          "export_file", {"Export", "The sheet as .svg, .pdf or .dxf; the edges in space as .ply. Empty: no file."},
          {".svg", ".pdf", ".dxf", ".ply"}),
  };
}

std::vector<ParameterSpec> parameters()
{
  std::vector<ParameterSpec> all = view_parameters();
  for (const auto& more : {kind_parameters(), line_parameters(), sheet_parameters(), curvature_source_parameters()})
    all = concatenate(std::move(all), more);
  return all;
}

std::vector<View> views_of(const ViewOptions& options)
{
  if (options.view < side_count) return {side_view(Side(options.view))};
  switch (ViewChoice(options.view)) {
    case ViewChoice::three_sides:
      return {side_view(Side::front), side_view(Side::right), side_view(Side::top)};
    case ViewChoice::direction:
      return {make_view("view", {options.toward_x, options.toward_y, options.toward_z},
                        {options.up_x, options.up_y, options.up_z})};
    case ViewChoice::six_sides:
      break;
  }
  std::vector<View> all;
  for (int side = 0; side < side_count; ++side) all.push_back(side_view(Side(side)));
  return all;
}

using Writer = std::string (*)(const Sheet&);

/// By the end of the file's name; null where the host writes the layer, or nothing.
Writer writer_of(const std::string& file)
{
  const std::map<std::string, Writer> writers{{"svg", svg_file}, {"pdf", pdf_file}, {"dxf", dxf_file}};
  std::string end = file.substr(file.rfind('.') + 1);
  for (char& c : end)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  const auto found = writers.find(end);
  return found == writers.end() ? nullptr : found->second;
}

/// "front: contours 2 (long 34.5), suggestive contours 7 (long 12.3)".
std::string view_line(const DrawnView& drawn, double unit)
{
  std::string line = drawn.view.name + ":";
  for (int k = 0; k < line_kind_count; ++k) {
    int count = 0;
    double length = 0;
    for (const ViewLine& l : drawn.lines)
      if (int(l.line.kind) == k) {
        ++count;
        length += l.line.length() * unit;
      }
    if (count > 0)
      line += std::string(line.back() == ':' ? " " : ", ") + kind_title(LineKind(k)) + " " + std::to_string(count) +
              " (length " + short_number(length) + ")";
  }
  return line.back() == ':' ? line + " no line is significant" : line;
}

std::string sheet_line(const Sheet& sheet)
{
  return "Sheet: " + decimal_text(sheet.width) + " mm x " + decimal_text(sheet.height) + " mm, scale " +
         scale_text(sheet.scale);
}

std::vector<DrawnView> drawn_views(MeasuredMesh& measured, const DifferentiatedField& field, const Request& request,
                                   const std::vector<View>& views)
{
  const Topology topology(measured.surface, measured.execution);
  const LineDrawing drawing(measured.surface, topology, field,
                            measured.curvature.noise / measured.curvature.average_edge, request.part<D>(),
                            measured.execution);
  std::vector<DrawnView> drawn;
  for (const View& view : views) {
    drawn.push_back({view, drawing.lines_of(view, measured.execution)});
    measured.execution.report(double(drawn.size()) / double(views.size()));
  }
  return drawn;
}

FilterResult run(const FilterInput& input, const ProgressCallback& progress)
{
  const Request& request = input.request;
  const Writer writer = writer_of(request.part<OutputOptions>().export_file);
  const std::vector<View> views = views_of(request.part<ViewOptions>());
  require_drawable(request.part<D>());
  MeasuredMesh measured(input, progress);
  const Surface& surface = measured.surface;
  measured.execution.begin_stage("derivative of the curvature", 50);
  const DifferentiatedField field = differentiate(surface, measured_field(measured.curvature), measured.execution);
  measured.execution.begin_stage("line drawing", 100);
  const std::vector<DrawnView> drawn = drawn_views(measured, field, request, views);

  FilterResult result;
  std::vector<std::string> findings;
  int lines = 0;
  for (const DrawnView& d : drawn) {
    lines += int(d.lines.size());
    findings.push_back(view_line(d, surface.unit()));
  }
  result.values = {{"lines", lines}};
  if (writer) {
    const Sheet sheet =
        make_sheet(drawn, field.position, surface.unit(), request.part<D>().significance, request.part<S>());
    result.file = writer(sheet);
    findings.push_back(sheet_line(sheet));
    result.values.emplace_back("scale", sheet.scale);
  }
  result.lines = drawing_layer(measured.canonical.mesh, surface, drawn, line_style(request));
  add_report(measured, "Line drawing", findings, result);
  return result;
}

}  // namespace

const Filter& line_drawing_filter()
{
  static const Filter filter{"Create Line Drawing",
                             "create_line_drawing",
                             help,
                             menu_layers | menu_normals_and_curvature,
                             0,
                             parameters(),
                             run};
  return filter;
}

}  // namespace integral_invariant::filter
