// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1: ball moments as sums over the triangles of the surface; no grid, no inside test, open meshes too.
//
// In: a checked surface. Out: moments of the ball about every vertex at every scale, with a confidence.
// Cost: with `exact` the number of triangles that the spheres of a vertex cut, Σ r_i/ē; else that up to 4ē, and beyond
// it the triangles and nodes of the hierarchy that stand for the rest. All scales in one pass. Memory: about 200 bytes
// a vertex. Source: docs/surface_engine.md.
#pragma once

#include <memory>

#include "integral_invariant/moments/engine.h"

namespace integral_invariant {

/// The engine prepared for `surface`; takes `exactness`, `same_sheet` and `memory_limit_mb` of the parameters.
/// \throw MemoryError
std::unique_ptr<MomentEngine> make_surface_engine(const Surface& surface, const Parameters& parameters,
                                                  Execution& execution);

}  // namespace integral_invariant
