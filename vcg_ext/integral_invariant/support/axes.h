// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// Orthonormal, right-handed; those of space unless set.
struct Axes {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  /// Of a vector, along these axes.
  Vec3 coordinates_of(const Vec3& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
  /// The vector that has these coordinates.
  Vec3 vector(const Vec3& coordinates) const { return x * coordinates.x + y * coordinates.y + z * coordinates.z; }
};

}  // namespace integral_invariant
