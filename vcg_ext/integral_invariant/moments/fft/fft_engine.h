// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1: ball moments by convolutions on a voxel grid [Pottmann07, Lai09 4.1]. In: a closed surface. Out: BallMoments
// of every vertex at every radius. Error O(h²) or better in the grid step (docs/fft_engine.md has order and figures).
#pragma once

#include <memory>

#include "integral_invariant/moments/engine.h"

namespace integral_invariant {

/// The engine on grids with `fft_cells_per_radius` cells per radius, one grid a scale; memory as `memory_limit_mb`
/// says. `surface` must outlive it. \throw InputError where the surface is not closed
std::unique_ptr<MomentEngine> make_fft_engine(const Surface& surface, const Parameters& parameters);

}  // namespace integral_invariant
