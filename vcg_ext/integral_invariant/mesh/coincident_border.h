// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "integral_invariant/mesh.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// Seams whose two sides are off each other by rounding. Vertices on open edges are taken for one place where no
/// coordinate of theirs differs by more than a few steps of the mesh's own precision (coordinate_step()), and that is
/// far less than the shortest edge of either. A mesh without open edges has none.
///
/// \return for each vertex the smallest number of a vertex at its place; empty where no two are to be joined
std::vector<std::uint32_t> coincident_border(const TriangleMesh& mesh, Execution& execution);

}  // namespace integral_invariant
