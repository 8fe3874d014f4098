// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/shuffle.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace test_support {

ShuffledMesh shuffled(const integral_invariant::TriangleMesh& mesh, std::uint32_t seed)
{
  std::mt19937 generator(seed);
  ShuffledMesh s;
  s.place.resize(mesh.positions.size());
  std::iota(s.place.begin(), s.place.end(), 0);
  std::shuffle(s.place.begin(), s.place.end(), generator);
  s.mesh = mesh;
  for (std::size_t v = 0; v < s.place.size(); ++v) s.mesh.positions[std::size_t(s.place[v])] = mesh.positions[v];
  for (integral_invariant::Triangle& t : s.mesh.triangles) {
    for (std::int32_t& v : t) v = s.place[std::size_t(v)];
    std::rotate(t.begin(), t.begin() + generator() % 3, t.end());
  }
  std::shuffle(s.mesh.triangles.begin(), s.mesh.triangles.end(), generator);
  return s;
}

Soup soup(const integral_invariant::TriangleMesh& mesh)
{
  Soup result;
  std::vector<char> used(mesh.positions.size(), 0);
  for (const integral_invariant::Triangle& t : mesh.triangles) {
    const auto first = std::int32_t(result.original.size());
    for (const std::int32_t v : t) {
      used[std::size_t(v)] = 1;
      result.original.push_back(v);
      result.mesh.positions.push_back(mesh.positions[std::size_t(v)]);
    }
    result.mesh.triangles.push_back({first, first + 1, first + 2});
  }
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) continue;
    result.original.push_back(std::int32_t(v));
    result.mesh.positions.push_back(mesh.positions[v]);
  }
  return result;
}

}  // namespace test_support
