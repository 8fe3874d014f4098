// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: orthographic views.
#pragma once

#include <string>

#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// Right-handed and orthonormal: x of the picture, y of the picture, and towards the viewer.
struct View {
  std::string name;  ///< of its layers in files: lower-case letters, digits and underscores
  Vec3 right{1, 0, 0}, up{0, 1, 0}, toward{0, 0, 1};

  /// x and y in the picture, and the depth, which grows towards the viewer.
  Vec3 project(const Vec3& p) const { return {dot(p, right), dot(p, up), dot(p, toward)}; }
};

/// The view of a viewer in the direction `toward` from the object; `up` need not be orthogonal to it.
/// \throw ParameterError where a vector is zero or not finite, or both are parallel
View make_view(const std::string& name, const Vec3& toward, const Vec3& up);

/// The six sides as MeshLab's View menu has them: front looks along −z with y up.
enum class Side { front = 0, back = 1, left = 2, right = 3, top = 4, bottom = 5 };
inline constexpr int side_count = 6;
View side_view(Side side);

}  // namespace integral_invariant
