// SPDX-License-Identifier: GPL-3.0-or-later
// Hatching. In: lines of curvature. Out: their stretches in the shade of a view.
#include "integral_invariant/drawing/hatching.h"

#include "integral_invariant/drawing/zero_lines.h"
#include "integral_invariant/features/curvature_lines.h"

namespace integral_invariant {

namespace {

constexpr double shade = 0.5, deep_shade = 0.2;  // n·l

void end_stretch(SurfaceLine& stretch, double minimum_length, std::vector<SurfaceLine>& kept)
{
  if (stretch.points.size() > 1 && stretch.length() >= minimum_length) kept.push_back(stretch);
  stretch.points.clear();
}

}  // namespace

std::vector<SurfaceLine> hatching_lines(const Surface& surface, const DifferentiatedField& field, double spacing,
                                        Execution& execution)
{
  DirectionParameters p;
  p.maximal = p.minimal = true;
  p.spacing = spacing;
  p.smoothing_passes = 0;  // the fits have smoothed
  std::vector<SurfaceLine> lines;
  for (const CurvatureLine& traced : trace_curvature_lines(surface, field.curvature, p, execution)) {
    SurfaceLine line{LineKind::hatching, {}, traced.closed};
    const double family = traced.family == DirectionFamily::minimal ? 1 : 2;
    for (const SurfacePoint& s : traced.points)
      line.points.push_back({interpolate(field.position, s), normalized(interpolate(field.curvature.normal, s)),
                             largest_significance, family});
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<SurfaceLine> hatching_in_shade(const std::vector<SurfaceLine>& lines, const View& view,
                                           double minimum_length)
{
  const Vec3 light = normalized(view.up + view.toward - view.right);
  std::vector<SurfaceLine> kept;
  for (const SurfaceLine& line : lines) {
    SurfaceLine stretch{LineKind::hatching, {}, false};
    for (std::size_t i = 0; i < line.points.size() + (line.closed ? 1 : 0); ++i) {
      const LinePoint& p = line.points[i % line.points.size()];
      const bool is_dark = dot(p.normal, light) < (p.strength > 1 ? deep_shade : shade);
      if (is_dark && dot(p.normal, view.toward) > 0)
        stretch.points.push_back(p);
      else
        end_stretch(stretch, minimum_length, kept);
    }
    end_stretch(stretch, minimum_length, kept);
  }
  return kept;
}

}  // namespace integral_invariant
