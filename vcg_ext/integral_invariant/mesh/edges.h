// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "integral_invariant/mesh.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// An undirected edge and how its triangles pass it.
struct Edge {
  std::uint32_t low, high;         ///< vertices
  std::int32_t forward, backward;  ///< passes from low to high, from high to low
};

/// Every edge once, ordered by (low, high). `vertices`: their number. Cost: O(m log valence), 48 bytes a triangle.
std::vector<Edge> list_edges(const std::vector<Triangle>& triangles, std::size_t vertices, Execution& execution);

}  // namespace integral_invariant
