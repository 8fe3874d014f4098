// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: lines on the surface, before they are seen from anywhere.
#pragma once

#include <vector>

#include "integral_invariant/vec3.h"

namespace integral_invariant {

enum class LineKind {
  contour = 0,
  boundary,
  crease,
  suggestive_contour,
  suggestive_highlight,
  apparent_ridge,
  ridge,
  valley,
  demarcating_curve,
  hatching,
  section,
};
inline constexpr int line_kind_count = 11;

/// Plural, in plain words, such as "suggestive contours"; and as a name of layers, such as "suggestive_contours".
const char* kind_title(LineKind kind);
const char* kind_name(LineKind kind);

/// The largest significance that is told apart: what has no error has this much.
inline constexpr double largest_significance = 1e4;

struct LinePoint {
  Vec3 position;            ///< ē
  Vec3 normal;              ///< unit, outward
  double significance = 0;  ///< z: what makes the line one, over its standard error
  double strength = 0;      ///< of the kind; 1/ē or 1/ē²
};

struct SurfaceLine {
  LineKind kind = LineKind::contour;
  std::vector<LinePoint> points;
  bool closed = false;  ///< the last point is joined to the first

  std::size_t segment_count() const { return points.empty() ? 0 : points.size() - (closed ? 0 : 1); }
  const LinePoint& end_of(std::size_t segment) const { return points[(segment + 1) % points.size()]; }
  double length_of(std::size_t segment) const { return norm(end_of(segment).position - points[segment].position); }
  double length() const
  {
    double sum = 0;
    for (std::size_t i = 0; i < segment_count(); ++i) sum += length_of(i);
    return sum;
  }
};

}  // namespace integral_invariant
