// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh as it is handed over.
#include "integral_invariant/triangle_mesh.h"

#include <algorithm>
#include <string>

#include "integral_invariant/support/error.h"

namespace integral_invariant {

void require_valid_indices(const TriangleMesh& mesh)
{
  const auto n = std::int64_t(mesh.positions.size());
  for (const Triangle& t : mesh.triangles)
    for (const std::int32_t v : t)
      if (v < 0 || v >= n)
        throw InputError("A face refers to vertex " + std::to_string(v) + ", but the mesh has " + std::to_string(n) +
                         " vertices. The mesh is damaged: load it anew or repair the file.");
}

Triangle smallest_first(const Triangle& t)
{
  if (t[0] <= t[1] && t[0] <= t[2]) return t;
  return t[1] <= t[2] ? Triangle{t[1], t[2], t[0]} : Triangle{t[2], t[0], t[1]};
}

bool is_proper(const Triangle& t, const std::vector<Vec3>& positions)
{
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && is_finite(positions[std::size_t(t[0])]) &&
         is_finite(positions[std::size_t(t[1])]) && is_finite(positions[std::size_t(t[2])]);
}

void Box::add(const Vec3& p)
{
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

bool precedes(std::uint32_t a, std::uint32_t b, const std::vector<Vec3>& positions)
{
  const Vec3 &p = positions[a], &q = positions[b];
  if (p.x != q.x) return p.x < q.x;
  if (p.y != q.y) return p.y < q.y;
  if (p.z != q.z) return p.z < q.z;
  return a < b;
}

}  // namespace integral_invariant
