// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: how much of a flat disc is missing where boundary edges pass within a ball; the confidence comes from
// it.
#pragma once

#include <cstdint>

#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// Angles under which boundary edges are seen from the centre, signed: positive where the surface ends there, negative
/// where it begins again; and the same times the squared distance. The area missing from a flat disc is ½ (r² angle −
/// moment).
struct MissingArea {
  double angle = 0, moment = 0;

  /// The part of an edge from `start` to `end`, seen from the origin.
  void add(const Vec3& start, const Vec3& end, double sign);
  MissingArea& operator+=(const MissingArea& b)
  {
    angle += b.angle;
    moment += b.moment;
    return *this;
  }
};

/// 1 − missing/(πr²) within [0, 1].
double confidence(const MissingArea& missing, double squared_radius);

/// +1 where the surface ends at the edge from a to b as seen from the origin, −1 where it begins; edges at which the
/// orientation turns over always end it.
double boundary_side(std::int32_t surplus, const Vec3& a, const Vec3& b, const Vec3& opposite);

/// In lengths of an edge: an edge nearer to the centre than this passes through it (a vertex on another triangle's
/// edge, rounded to single precision and then some).
inline constexpr double touching = 1e-3;

/// Whether the edge from a to b goes through the origin between its ends.
bool passes_origin(const Vec3& a, const Vec3& b);

}  // namespace integral_invariant
