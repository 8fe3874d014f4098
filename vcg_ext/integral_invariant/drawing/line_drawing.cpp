// SPDX-License-Identifier: GPL-3.0-or-later
// All lines of a surface and of its views. In: differentiated field. Out: smooth polylines, cut by visibility.
#include "integral_invariant/drawing/line_drawing.h"

#include <cmath>
#include <string>

#include "integral_invariant/drawing/edge_lines.h"
#include "integral_invariant/drawing/hatching.h"
#include "integral_invariant/drawing/line_scalars.h"
#include "integral_invariant/drawing/line_smoothing.h"
#include "integral_invariant/drawing/ridge_scalars.h"
#include "integral_invariant/drawing/visibility.h"
#include "integral_invariant/error.h"

namespace integral_invariant {

namespace {

constexpr double spacing = 0.5;        // ē, of the points of smooth lines
constexpr double usual_length = 5;     // ē
constexpr double shortest_change = 3;  // ē, of visibility
constexpr double usual_hatching = 4;   // ē
constexpr int most_sections = 1000;

/// ē. Zeros of a function wander with its noise; edges of the mesh only step.
double smoothing_width(LineKind kind)
{
  switch (kind) {
    case LineKind::boundary:
    case LineKind::crease:
      return 1;
    case LineKind::hatching:
      return 0.5;
    default:
      return 2;
  }
}

void require(bool holds, const std::string& sentence)
{
  if (!holds) throw ParameterError(sentence);
}

}  // namespace

void require_drawable(const LineDrawingParameters& p)
{
  require(p.contours || p.boundaries || p.creases || p.suggestive_contours || p.suggestive_highlights ||
              p.apparent_ridges || p.ridges || p.valleys || p.demarcating_curves || p.hatching || p.sections > 0,
          "No kind of line is asked for: set 'contours' or another kind to true.");
  require(p.sections >= 0 && p.sections <= most_sections,
          "The parameter 'sections' must be from 0 to " + std::to_string(most_sections) + ".");
  require(p.significance >= 0 && std::isfinite(p.significance), "The parameter 'significance' must not be negative.");
  require(p.minimum_length >= 0 && std::isfinite(p.minimum_length),
          "The parameter 'minimum_length' must not be negative.");
  require(p.crease_angle > 0 && p.crease_angle <= 180,
          "The parameter 'crease_angle' must be over 0 and at most 180 degrees.");
  require(p.hatching_spacing >= 0 && std::isfinite(p.hatching_spacing),
          "The parameter 'hatching_spacing' must not be negative.");
}

namespace {

/// The pieces of the line that are all visible or all hidden; a change lies halfway between two points.
void cut_by_visibility(const SurfaceLine& line, const std::vector<char>& visible, HiddenLines hidden,
                       std::vector<ViewLine>& pieces)
{
  const std::size_t n = line.points.size();
  std::size_t start = 0;
  if (line.closed) {
    while (start < n && visible[start] == visible[(start + n - 1) % n]) ++start;
    if (start == n) {
      if (visible[0] || hidden == HiddenLines::dashed) pieces.push_back({line, visible[0] != 0});
      return;
    }
  }
  const auto middle = [&](std::size_t a, std::size_t b) {
    LinePoint p = line.points[a];
    p.position = (p.position + line.points[b].position) * 0.5;
    return p;
  };
  for (std::size_t i = 0; i < n;) {
    std::size_t end = i;
    ViewLine piece{{line.kind, {}, false}, visible[(start + i) % n] != 0};
    if (i > 0 || line.closed) piece.line.points.push_back(middle((start + i) % n, (start + i + n - 1) % n));
    for (; end < n && (visible[(start + end) % n] != 0) == piece.visible; ++end)
      piece.line.points.push_back(line.points[(start + end) % n]);
    if (end < n || line.closed) piece.line.points.push_back(middle((start + end - 1) % n, (start + end) % n));
    if ((piece.visible || hidden == HiddenLines::dashed) && piece.line.points.size() > 1)
      pieces.push_back(std::move(piece));
    i = end;
  }
}

}  // namespace

LineDrawing::LineDrawing(const Surface& surface, const Topology& topology, const DifferentiatedField& field,
                         double noise, const LineDrawingParameters& parameters, Execution& execution)
    : surface_(surface), topology_(topology), field_(field), parameters_(parameters)
{
  require_drawable(parameters);
  selection_.significance = parameters.significance;
  selection_.minimum_length = parameters.minimum_length > 0 ? parameters.minimum_length / surface.unit() : usual_length;
  find_edges(noise, execution);
  find_extrema(execution);
  find_sections(execution);
  find_hatching(execution);
}

void LineDrawing::add(const std::vector<SurfaceLine>& lines, std::vector<SurfaceLine>& all) const
{
  for (const SurfaceLine& line : lines) all.push_back(smoothed_line(line, smoothing_width(line.kind), spacing));
}

std::vector<SurfaceLine> LineDrawing::zeros(const LineScalar& scalar, Execution& execution) const
{
  return zero_lines(surface_, topology_, field_, scalar, selection_, execution);
}

void LineDrawing::find_edges(double noise, Execution& execution)
{
  if (parameters_.boundaries) add(boundary_lines(surface_, topology_, field_, selection_, execution), fixed_lines_);
  if (parameters_.creases)
    add(crease_lines(surface_, topology_, field_, parameters_.crease_angle, noise, selection_, execution),
        fixed_lines_);
}

void LineDrawing::find_extrema(Execution& execution)
{
  for (const LineKind kind : {LineKind::ridge, LineKind::valley})
    if (kind == LineKind::ridge ? parameters_.ridges : parameters_.valleys)
      add(zeros(ridge_scalar(surface_, field_, kind, execution), execution), fixed_lines_);
  if (parameters_.demarcating_curves) add(zeros(demarcating_scalar(field_, execution), execution), fixed_lines_);
}

void LineDrawing::find_sections(Execution& execution)
{
  if (parameters_.sections == 0) return;
  const Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Vec3 normal = axes[int(parameters_.section_axis)];
  double low = 1e300, high = -1e300;
  for (const Triangle& t : surface_.triangles())
    for (const std::int32_t v : t) {
      low = std::min(low, dot(field_.position[v], normal));
      high = std::max(high, dot(field_.position[v], normal));
    }
  for (int i = 0; i < parameters_.sections; ++i) {
    const double offset = low + (high - low) * (i + 1) / (parameters_.sections + 1);
    add(zeros(section_scalar(field_, normal, offset, execution), execution), fixed_lines_);
  }
}

void LineDrawing::find_hatching(Execution& execution)
{
  if (!parameters_.hatching) return;
  const double between =
      parameters_.hatching_spacing > 0 ? parameters_.hatching_spacing : usual_hatching * surface_.unit();
  add(hatching_lines(surface_, field_, between, execution), hatching_lines_);
}

std::vector<SurfaceLine> LineDrawing::lines_seen_from(const View& view, Execution& execution) const
{
  std::vector<SurfaceLine> lines;
  if (parameters_.contours) add(zeros(contour_scalar(field_, view, execution), execution), lines);
  lines.insert(lines.end(), fixed_lines_.begin(), fixed_lines_.end());
  for (const LineKind kind : {LineKind::suggestive_contour, LineKind::suggestive_highlight})
    if (kind == LineKind::suggestive_contour ? parameters_.suggestive_contours : parameters_.suggestive_highlights)
      add(zeros(suggestive_scalar(field_, view, kind, execution), execution), lines);
  if (parameters_.apparent_ridges)
    add(zeros(apparent_ridge_scalar(surface_, field_, view, execution), execution), lines);
  const std::vector<SurfaceLine> dark = hatching_in_shade(hatching_lines_, view, selection_.minimum_length);
  lines.insert(lines.end(), dark.begin(), dark.end());
  return lines;
}

std::vector<ViewLine> LineDrawing::lines_of(const View& view, Execution& execution) const
{
  const std::vector<SurfaceLine> lines = lines_seen_from(view, execution);
  const DepthGrid grid(field_.position, surface_.triangles(), view, execution);
  std::vector<std::vector<char>> visible(lines.size());
  parallel_step(lines.size(), 1, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) visible[i] = visible_points(lines[i], grid, view, shortest_change);
  });
  std::vector<ViewLine> pieces;
  for (std::size_t i = 0; i < lines.size(); ++i) cut_by_visibility(lines[i], visible[i], parameters_.hidden, pieces);
  return pieces;
}

}  // namespace integral_invariant
