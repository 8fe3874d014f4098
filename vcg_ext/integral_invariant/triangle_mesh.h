// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "integral_invariant/support/vec3.h"

namespace integral_invariant {

using Triangle = std::array<std::int32_t, 3>;

/// A triangle mesh as the caller has it: n vertices, m triangles, oriented outward.
struct TriangleMesh {
  std::vector<Vec3> positions;       ///< n, in the caller's unit
  std::vector<Triangle> triangles;   ///< m, indices into positions
};

/// \throw InputError naming the first index of a triangle that is no vertex of the mesh
void require_valid_indices(const TriangleMesh& mesh);

/// The same triangle, same orientation, from its smallest index on.
Triangle smallest_first(const Triangle& t);

/// Three different vertices whose coordinates are finite: what can be part of a surface.
bool is_proper(const Triangle& t, const std::vector<Vec3>& positions);

/// The smallest box around the points added.
struct Box {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

  void add(const Vec3& p);
};

/// By coordinates, x first; vertices at the same place by index.
bool precedes(std::uint32_t a, std::uint32_t b, const std::vector<Vec3>& positions);

}  // namespace integral_invariant
