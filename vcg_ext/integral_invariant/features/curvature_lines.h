// SPDX-License-Identifier: GPL-3.0-or-later
// Features: the principal directions as short segments, and as traced lines of curvature.
#pragma once

#include <cstddef>
#include <vector>

#include "integral_invariant/features/curvature_field.h"
#include "integral_invariant/features/surface_point.h"

namespace integral_invariant {

enum class DirectionFamily { maximal = 0, minimal = 1 };

struct DirectionParameters {
  bool maximal = true, minimal = false;  ///< which directions
  double spacing = 0;                    ///< L; between lines, or between segments; 0: three average edge lengths
  double segment_length = 0;             ///< L; of segments; 0: eight tenths of the spacing
  double minimum_length = 0;             ///< L; shorter traced lines are dropped; 0: twice the spacing
  double umbilic = 0.1;  ///< lines end, and segments are left out, where κ_max − κ_min is under this part of |κ|
  int smoothing_passes = 1;         ///< of the curvatures over the mesh, before the lines are traced
  std::size_t memory_limit_mb = 0;  ///< 0: half of the machine's memory
};

/// A line of length 2 |half| centred at a vertex, in its tangent plane.
struct DirectionSegment {
  DirectionFamily family;
  std::int32_t vertex;
  Vec3 half;  ///< L: from the vertex to one end
};

/// Why a line ends; `length`: no further progress.
enum class LineEnd { umbilic, boundary, near_line, loop, length };

struct CurvatureLine {
  DirectionFamily family = DirectionFamily::maximal;
  std::vector<SurfacePoint> points;  ///< one a crossed edge
  bool closed = false;               ///< the last point is joined to the first
  LineEnd begins = LineEnd::length, ends = LineEnd::length;
  double length = 0;  ///< L
};

/// Segments at vertices that are at least the spacing apart, first come first served. Cost: O(n).
/// \throw Cancelled, or ParameterError where a length is out of its range
std::vector<DirectionSegment> direction_segments(const Surface& surface, const CurvatureField& field,
                                                 const DirectionParameters& parameters, Execution& execution);

/// Evenly spaced lines of curvature: a line starts at the spacing from those before it, and ends where it comes nearer
/// than half of that to another of its family, at an umbilic, at a boundary, or where it returns to its start. The next
/// seeds lie beside the line just traced; places that no line reached are seeded where the directions are clearest.
/// `field` is in normalised units and belongs to `surface`. One thread. Cost: O(m log m) and that of the lines.
/// \throw ParameterError as above; MemoryError where lines so close would not fit; Cancelled
std::vector<CurvatureLine> trace_curvature_lines(const Surface& surface, const CurvatureField& field,
                                                 const DirectionParameters& parameters, Execution& execution);

/// How clearly the directions of a point differ: (κ_max − κ_min) / hypot(max |κ|, typical), 0 at an umbilic, at most 2.
/// `typical` (1/ē), the median of max |κ| over the mesh, keeps flat places from having directions made of rounding.
double anisotropy(double kappa_max, double kappa_min, double typical);
double typical_curvature(const CurvatureField& field);

}  // namespace integral_invariant
