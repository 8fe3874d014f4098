// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on the surface as layers of edges.
#include "line_layer.h"

#include <algorithm>
#include <limits>

namespace integral_invariant::filter {

namespace {

/// In the single precision of attributes, which a mesh in very small units leaves.
float storable(double value)
{
  constexpr double largest = std::numeric_limits<float>::max();
  return float(std::clamp(value, -largest, largest));
}

class LayerBuilder {
 public:
  LayerBuilder(const char* label, const LineStyle& style, double average_edge)
      : colorize_(style.colorize), lift_(style.lift * average_edge)
  {
    layer_.label = label;
    layer_.attributes = {{"ii_line", {}}, {"ii_kind", {}}, {"ii_strength", {}}};
  }

  void begin_line(bool first_kind)
  {
    first_kind_ = first_kind;
    start_ = std::int32_t(layer_.positions.size());
    ++line_;
  }

  void add_point(const Vec3& position, const Vec3& normal, double strength)
  {
    const std::int32_t index = std::int32_t(layer_.positions.size());
    if (index > start_) layer_.edges.push_back({index - 1, index});
    layer_.normals.push_back(normalized(normal));
    layer_.positions.push_back(position + layer_.normals.back() * lift_);
    layer_.quality.push_back(strength);
    if (colorize_) layer_.colors.push_back(first_kind_ ? first_color : second_color);
    layer_.attributes[0].values.push_back(float(line_));
    layer_.attributes[1].values.push_back(first_kind_ ? 1.0F : -1.0F);
    layer_.attributes[2].values.push_back(storable(strength));
  }

  void end_line(bool closed)
  {
    const std::int32_t last = std::int32_t(layer_.positions.size()) - 1;
    if (closed && last > start_ + 1) layer_.edges.push_back({last, start_});
  }

  LineLayer take() { return std::move(layer_); }

 private:
  LineLayer layer_;
  bool colorize_, first_kind_ = true;
  double lift_;  // in the caller's unit
  int line_ = -1;
  std::int32_t start_ = 0;
};

}  // namespace

LineStyle line_style(const Request& request)
{
  return {request.part<OutputOptions>().colorize, request.part<LayerOptions>().lift};
}

ParameterSpec line_lift_parameter()
{
  return real<&LayerOptions::lift>(
      "lift", "average edges", {0, 1},
      {"Height over the surface (edges)",
       "Lines stand this many average edge lengths above the surface, so that it does not hide them. 0: on it."});
}

ParameterSpec line_export_parameter()
{
  return save_file<&OutputOptions::export_file>(
      "export_file",
      {"Export to PLY",
       "Writes the lines as vertices and edges, with the properties ii_line, ii_kind and ii_strength of the vertices. "
       "Empty: no file."});
}

LineLayer crest_layer(const TriangleMesh& mesh, const Result& result, const std::vector<CrestLine>& lines,
                      const LineStyle& style)
{
  LayerBuilder builder("Crest lines", style, result.average_edge);
  for (const CrestLine& line : lines) {
    builder.begin_line(line.kind == FeatureKind::ridge);
    for (const SurfacePoint& p : line.points)
      builder.add_point(interpolate(mesh.positions, p), interpolate(result.normal, p), line.strength);
    builder.end_line(line.closed);
  }
  return builder.take();
}

LineLayer curvature_line_layer(const TriangleMesh& mesh, const Result& result, const std::vector<CurvatureLine>& lines,
                               const LineStyle& style)
{
  LayerBuilder builder("Lines of curvature", style, result.average_edge);
  for (const CurvatureLine& line : lines) {
    const bool maximal = line.family == DirectionFamily::maximal;
    builder.begin_line(maximal);
    for (const SurfacePoint& p : line.points)
      builder.add_point(interpolate(mesh.positions, p), interpolate(result.normal, p),
                        interpolate(maximal ? result.kappa_max : result.kappa_min, p));
    builder.end_line(line.closed);
  }
  return builder.take();
}

LineLayer segment_layer(const TriangleMesh& mesh, const Result& result, const std::vector<DirectionSegment>& segments,
                        const LineStyle& style)
{
  LayerBuilder builder("Principal directions", style, result.average_edge);
  for (const DirectionSegment& segment : segments) {
    const auto v = std::size_t(segment.vertex);
    const bool maximal = segment.family == DirectionFamily::maximal;
    const double strength = maximal ? result.kappa_max[v] : result.kappa_min[v];
    builder.begin_line(maximal);
    for (const double end : {-1.0, 1.0})
      builder.add_point(mesh.positions[v] + segment.half * end, result.normal[v], strength);
  }
  return builder.take();
}

}  // namespace integral_invariant::filter
