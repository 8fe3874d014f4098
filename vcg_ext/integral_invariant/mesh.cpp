// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh as it is handed over.
#include "integral_invariant/mesh.h"

#include <string>

#include "integral_invariant/error.h"

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

void refuse_without_area()
{
  throw InputError("No face of the mesh has an area. Check the mesh, for example with \"Remove Zero Area Faces\".");
}

}  // namespace integral_invariant
