// SPDX-License-Identifier: GPL-3.0-or-later
// Line drawings as layers of edges.
#include "drawing_layer.h"

#include <algorithm>

namespace integral_invariant::filter {

namespace {

constexpr Color ink{20, 20, 20}, hidden_ink{160, 160, 160};

Color color_of(const ViewLine& line)
{
  if (!line.visible) return hidden_ink;
  switch (line.line.kind) {
    case LineKind::ridge:
    case LineKind::apparent_ridge:
      return first_color;
    case LineKind::valley:
    case LineKind::demarcating_curve:
      return second_color;
    default:
      return ink;
  }
}

/// From ē to the caller's coordinates.
struct Placement {
  double unit = 1;
  Vec3 origin;

  Placement(const TriangleMesh& mesh, const Surface& surface) : unit(surface.unit())
  {
    const std::size_t v = std::size_t(surface.triangles().front()[0]);
    origin = mesh.positions[v] - surface.positions()[v] * unit;
  }
};

class DrawingBuilder {
 public:
  DrawingBuilder(const Placement& place, const LineStyle& style) : place_(place), style_(style)
  {
    layer_.label = "Line drawing";
    for (const char* name : {"ii_line", "ii_kind", "ii_z", "ii_strength", "ii_visible", "ii_view"})
      layer_.attributes.push_back({name, {}});
  }

  void add(const ViewLine& line, int view)
  {
    const auto first = std::int32_t(layer_.positions.size());
    for (const LinePoint& p : line.line.points) add_point(p, line, view);
    const auto last = std::int32_t(layer_.positions.size()) - 1;
    for (std::int32_t i = first; i < last; ++i) layer_.edges.push_back({i, i + 1});
    if (line.line.closed) layer_.edges.push_back({last, first});
    ++count_;
  }

  LineLayer take() { return std::move(layer_); }

 private:
  void add_point(const LinePoint& p, const ViewLine& line, int view)
  {
    layer_.positions.push_back((p.position + p.normal * style_.lift) * place_.unit + place_.origin);
    layer_.normals.push_back(p.normal);
    layer_.quality.push_back(p.significance);
    if (style_.colorize) layer_.colors.push_back(color_of(line));
    const double values[] = {double(count_), double(int(line.line.kind)), p.significance,
                             p.strength,     line.visible ? 1.0 : 0.0,    double(view)};
    for (std::size_t i = 0; i < std::size(values); ++i) layer_.attributes[i].values.push_back(float(values[i]));
  }

  Placement place_;
  LineStyle style_;
  LineLayer layer_;
  int count_ = 0;
};

}  // namespace

LineLayer drawing_layer(const TriangleMesh& mesh, const Surface& surface, const std::vector<DrawnView>& views,
                        const LineStyle& style)
{
  DrawingBuilder builder(Placement(mesh, surface), style);
  for (std::size_t v = 0; v < views.size(); ++v)
    for (const ViewLine& line : views[v].lines) builder.add(line, int(v));
  return builder.take();
}

}  // namespace integral_invariant::filter
