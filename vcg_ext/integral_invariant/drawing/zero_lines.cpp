// SPDX-License-Identifier: GPL-3.0-or-later
// Zeros of a function of the vertices as lines. In: values. Out: polylines that cross a side of a triangle at each
// point.
#include "integral_invariant/drawing/zero_lines.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/features/curve_linking.h"
#include "integral_invariant/features/surface_point.h"

namespace integral_invariant {

namespace {

constexpr double low_over_high = 0.25;  // of the hysteresis
constexpr double least_cosine = 0.5;    // 60 degrees between the directions at the ends of an edge

class ZeroFinder {
 public:
  ZeroFinder(const Surface& surface, const DifferentiatedField& field, const LineScalar& scalar)
      : surface_(surface), field_(field), scalar_(scalar)
  {
  }

  CurveSegment segment_in(const Triangle& t) const
  {
    CurveSegment segment;
    int found = 0;
    for (int i = 0; i < 3; ++i)
      if (is_crossed(t[i], t[(i + 1) % 3])) {
        if (found == 2) return {};
        segment.side[std::size_t(found++)] = i;
      }
    segment.exists = found == 2;
    return segment;
  }

  /// Whether the derivative falls along its direction, so that the zero is a maximum.
  bool is_maximum(const Triangle& t) const
  {
    const std::vector<Vec3>& d = scalar_.direction;
    const TriangleFrame frame(t, field_.position);
    std::array<double, 3> value{};
    Vec3 direction;
    for (int i = 0; i < 3; ++i) {
      const double sign = dot(d[t[0]], d[t[i]]) < 0 ? -1 : 1;
      value[i] = sign * scalar_.value[t[i]];
      direction += d[t[i]] * sign;
    }
    return dot(frame.gradient_of(value[0], value[1], value[2]), direction) < 0;
  }

  LinePoint point(const Triangle& t, int side) const
  {
    const std::int32_t a = std::min(t[side], t[(side + 1) % 3]), b = std::max(t[side], t[(side + 1) % 3]);
    const double va = std::abs(scalar_.value[a]), vb = std::abs(scalar_.value[b]);
    const SurfacePoint p = edge_point(a, b, va + vb > 0 ? va / (va + vb) : 0.5);
    const double z = std::min(scalar_.significance[a], largest_significance) * p.weights[0] +
                     std::min(scalar_.significance[b], largest_significance) * p.weights[1];
    return {interpolate(field_.position, p), normalized(interpolate(field_.curvature.normal, p)), z,
            interpolate(scalar_.strength, p)};
  }

  SurfaceLine line(const Curve& curve) const
  {
    SurfaceLine line{scalar_.kind, {}, curve.closed};
    const auto& triangles = surface_.triangles();
    for (const CurveStep& step : curve.steps) line.points.push_back(point(triangles[step.triangle], step.enter));
    if (!curve.closed) line.points.push_back(point(triangles[curve.steps.back().triangle], curve.steps.back().leave));
    if (scalar_.is_derivative)
      for (std::size_t i = 0; i < curve.steps.size(); ++i)
        if (!is_maximum(triangles[curve.steps[i].triangle])) line.points[i].significance = 0;
    return line;
  }

 private:
  /// Whether the value changes its sign between the ends, whose directions are signed alike. A zero takes the side of
  /// its own direction: consistent for all triangles around the vertex.
  bool is_crossed(std::int32_t a, std::int32_t b) const
  {
    const bool up_a = scalar_.value[a] >= 0, up_b = scalar_.value[b] >= 0;
    if (scalar_.direction.empty()) return up_a != up_b;
    const double cosine = dot(scalar_.direction[a], scalar_.direction[b]);
    if (!scalar_.is_derivative) return up_a != up_b && cosine > least_cosine;
    return std::abs(cosine) > least_cosine && (cosine > 0 ? up_a != up_b : up_a == up_b);
  }

  const Surface& surface_;
  const DifferentiatedField& field_;
  const LineScalar& scalar_;
};

/// Whether a piece of that length (the whole line, where it is shorter) is significant on average.
bool has_significant_piece(const SurfaceLine& line, double length, double significance)
{
  double piece = 0, sum = 0;
  std::size_t first = 0;
  const auto add = [&](std::size_t i, double sign) {
    const double ds = line.length_of(i);
    piece += sign * ds;
    sum += sign * ds * (line.points[i].significance + line.end_of(i).significance) / 2;
  };
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    add(i, 1);
    while (first < i && piece - line.length_of(first) >= length) add(first++, -1);
    if (piece >= length && sum >= significance * piece) return true;
  }
  return false;
}

bool is_wanted(const SurfaceLine& line, const LineSelection& selection)
{
  return line.length() >= selection.minimum_length &&
         has_significant_piece(line, selection.minimum_length, selection.significance);
}

}  // namespace

void keep_significant(const SurfaceLine& line, const LineSelection& selection, std::vector<SurfaceLine>& kept)
{
  const std::size_t n = line.points.size();
  std::vector<char> keep(n);
  for (std::size_t i = 0; i < n; ++i) keep[i] = line.points[i].significance >= low_over_high * selection.significance;
  for (const Stretch& stretch : kept_stretches(std::move(keep), line.closed)) {
    SurfaceLine piece{line.kind, {}, line.closed && stretch.count == n};
    for (std::size_t i = 0; i < stretch.count; ++i) piece.points.push_back(line.points[(stretch.first + i) % n]);
    if (piece.points.size() > 1 && is_wanted(piece, selection)) kept.push_back(std::move(piece));
  }
}

std::vector<SurfaceLine> zero_lines(const Surface& surface, const Topology& topology, const DifferentiatedField& field,
                                    const LineScalar& scalar, const LineSelection& selection, Execution& execution)
{
  const ZeroFinder finder(surface, field, scalar);
  std::vector<CurveSegment> segments;
  resize_in_steps(segments, surface.triangles().size(), execution);
  for_each_index(segments.size(), execution,
                 [&](std::size_t t) { segments[t] = finder.segment_in(surface.triangles()[t]); });
  std::vector<SurfaceLine> lines;
  for (const Curve& curve : link_curves(topology, segments, execution))
    keep_significant(finder.line(curve), selection, lines);
  return lines;
}

}  // namespace integral_invariant
