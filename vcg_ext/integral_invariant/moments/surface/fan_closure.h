// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: closing the surface around a vertex where it ends, by continuing the tangent plane.
#pragma once

#include <utility>
#include <vector>

#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// An end of the surface at a vertex: a boundary edge that leads to it (`arriving`) or away from it.
struct FanRay {
  Vec3 direction;  ///< unit, from the vertex
  bool arriving;
  double angle = 0;  ///< about the normal; filled in by close_fans()
};

/// Great arcs that lead from each arriving ray to a leaving one, counter-clockwise about the unit vector `normal`
/// through the gap between the fans: what the tangent plane adds. Several fans are closed from one to the next. Every
/// vertex has as many arriving rays as leaving ones. Returns the arcs' ends (unit vectors, less than half a turn apart)
/// and adds the gaps' angles to `gap`. Cost O(k log k) for k rays.
std::vector<std::pair<Vec3, Vec3>> close_fans(std::vector<FanRay> rays, const Vec3& normal, double& gap);

}  // namespace integral_invariant
