// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of triangles. In: triangles. Out: edges, with how often they are passed either way.
#include "integral_invariant/edge_list.h"

#include <algorithm>
#include <numeric>

namespace integral_invariant {

namespace {

/// How a triangle passes one of its sides.
struct Pass {
  std::uint32_t high;
  bool forward;
};

/// Calls visit(low, pass) for the sides of all triangles.
template <class Visit>
void for_each_pass(const std::vector<Triangle>& triangles, const Visit& visit)
{
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto from = std::uint32_t(t[i]), to = std::uint32_t(t[(i + 1) % 3]);
      visit(std::min(from, to), Pass{std::max(from, to), from < to});
    }
}

}  // namespace

std::vector<Edge> edge_list(const std::vector<Triangle>& triangles, std::size_t vertices, Execution& execution)
{
  // Bucketed by the lower end; each bucket is short.
  std::vector<std::uint32_t> next(vertices + 1, 0);
  for_each_pass(triangles, [&](std::uint32_t low, const Pass&) { ++next[low + 1]; });
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Pass> passes(3 * triangles.size());
  for_each_pass(triangles, [&](std::uint32_t low, const Pass& pass) { passes[next[low]++] = pass; });
  // Filled, a bucket ends where its start has moved to.
  for_each_index(vertices, execution, [&](std::size_t v) {
    std::sort(passes.data() + (v == 0 ? 0 : next[v - 1]), passes.data() + next[v],
              [](const Pass& a, const Pass& b) { return a.high < b.high; });
  });

  std::vector<Edge> edges;
  edges.reserve(passes.size() / 2);
  Pass* pass = passes.data();
  for (std::size_t v = 0; v < vertices; ++v) {
    Pass* const end = passes.data() + next[v];
    while (pass != end) {
      Edge edge{std::uint32_t(v), pass->high, 0, 0};
      for (; pass != end && pass->high == edge.high; ++pass) ++(pass->forward ? edge.forward : edge.backward);
      edges.push_back(edge);
    }
  }
  return edges;
}

}  // namespace integral_invariant
