// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of triangles. In: triangles. Out: edges, with how often they are passed either way.
#include "integral_invariant/mesh/edges.h"

#include <algorithm>

#include "integral_invariant/support/buckets.h"
#include "integral_invariant/support/large_pages.h"

namespace integral_invariant {

namespace {

/// How a triangle passes one of its sides.
struct Pass {
  std::uint32_t high;
  bool forward;
};

}  // namespace

std::vector<Edge> list_edges(const std::vector<Triangle>& triangles, std::size_t vertices, Execution& execution)
{
  // By the lower end: those buckets are short.
  Buckets<Pass> passes = in_buckets<Pass>(triangles.size(), vertices, execution, [&](std::size_t i, const auto& put) {
    const Triangle& t = triangles[i];
    for (std::size_t side = 0; side < 3; ++side) {
      const auto from = std::uint32_t(t[side]), to = std::uint32_t(t[(side + 1) % 3]);
      put(std::min(from, to), Pass{std::max(from, to), from < to});
    }
  });
  for_each_index(vertices, execution, [&](std::size_t v) {
    std::sort(passes.begin(v), passes.end(v), [](const Pass& a, const Pass& b) { return a.high < b.high; });
  });

  std::vector<Edge> edges;
  reserve_large(edges, passes.items.size() / 2);
  for_each_in_order(vertices, execution, [&](std::size_t v) {
    for (const Pass *pass = passes.begin(v), *end = passes.end(v); pass != end;) {
      Edge edge{std::uint32_t(v), pass->high, 0, 0};
      for (; pass != end && pass->high == edge.high; ++pass) ++(pass->forward ? edge.forward : edge.backward);
      edges.push_back(edge);
    }
  });
  return edges;
}

}  // namespace integral_invariant
