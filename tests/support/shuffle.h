// SPDX-License-Identifier: GPL-3.0-or-later
// The same mesh in another order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "integral_invariant/mesh.h"

namespace test_support {

struct ShuffledMesh {
  integral_invariant::TriangleMesh mesh;
  std::vector<std::int32_t> place;  ///< vertex v of the original is vertex place[v] here

  /// What belongs to the vertices here, in the order of the original.
  template <class Value>
  std::vector<Value> back(const std::vector<Value>& values) const
  {
    std::vector<Value> original;
    for (const std::int32_t v : place) original.push_back(values.at(std::size_t(v)));
    return original;
  }
};

/// Vertices and faces in a random order, each face from a random corner on; same seed, same order.
ShuffledMesh shuffled(const integral_invariant::TriangleMesh& mesh, std::uint32_t seed);

/// A mesh whose triangles share no vertex: each corner is a copy of its own. Vertices without a triangle come last.
struct Soup {
  integral_invariant::TriangleMesh mesh;
  std::vector<std::int32_t> original;  ///< vertex v here is a copy of vertex original[v]

  /// What belongs to the vertices of the original, as the copies should have it.
  template <class Value>
  std::vector<Value> copies(const std::vector<Value>& values) const
  {
    std::vector<Value> result;
    for (const std::int32_t v : original) result.push_back(values.at(std::size_t(v)));
    return result;
  }
};
Soup soup(const integral_invariant::TriangleMesh& mesh);

}  // namespace test_support
