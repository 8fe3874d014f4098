// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 4: bilateral smoothing of the radius over the surface [Lai09 eq. 9].
#pragma once

#include <vector>

#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// `passes` of r_v ← Σ w_u r_u / Σ w_u over v and its neighbours u, w_u = exp(−|p_v − p_u|²/(2σ₁²) − (r_v −
/// r_u)²/(2σ₂²)), σ₁ the average edge length and σ₂ the average |Δr| along edges, found anew for each pass. Cost O(n) a
/// pass.
std::vector<double> smooth_radii(const Surface& surface, std::vector<double> radii, int passes, Execution& execution);

}  // namespace integral_invariant
