// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "integral_invariant/vec3.h"

namespace integral_invariant {

using Triangle = std::array<std::int32_t, 3>;

/// A triangle mesh as the caller has it: n vertices, m triangles, oriented outward.
struct TriangleMesh {
  std::vector<Vec3> positions;      ///< n, in the caller's unit
  std::vector<Triangle> triangles;  ///< m, indices into positions
};

/// \throw InputError naming the first index of a triangle that is no vertex of the mesh
void require_valid_indices(const TriangleMesh& mesh);

/// \throw InputError: there is nothing to measure on
[[noreturn]] void refuse_without_area();

/// The same triangle, same orientation, from its smallest index on.
inline Triangle smallest_first(const Triangle& t)
{
  if (t[0] <= t[1] && t[0] <= t[2]) return t;
  return t[1] <= t[2] ? Triangle{t[1], t[2], t[0]} : Triangle{t[2], t[0], t[1]};
}

/// Three different vertices whose coordinates are finite: what can be part of a surface.
inline bool is_proper(const Triangle& t, const std::vector<Vec3>& positions)
{
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && is_finite(positions[std::size_t(t[0])]) &&
         is_finite(positions[std::size_t(t[1])]) && is_finite(positions[std::size_t(t[2])]);
}

/// The smallest box around the points added.
struct Box {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

  void add(const Vec3& p)
  {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

/// By coordinates, x first; vertices at the same place by index.
inline bool precedes(std::uint32_t a, std::uint32_t b, const std::vector<Vec3>& positions)
{
  const Vec3 &p = positions[a], &q = positions[b];
  if (p.x != q.x) return p.x < q.x;
  if (p.y != q.y) return p.y < q.y;
  if (p.z != q.z) return p.z < q.z;
  return a < b;
}

}  // namespace integral_invariant
