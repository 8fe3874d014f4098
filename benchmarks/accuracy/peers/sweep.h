// SPDX-License-Identifier: GPL-3.0-or-later
// One estimator at every radius of the sweep.
#pragma once

#include <functional>

#include "peers/peer.h"

namespace accuracy {

/// Calls `take(radius, metrics, seconds)` for radii from 1 to 40 times `edge`; once, with radius 0, for an estimator
/// that takes none. The sweep ends early where both errors are many times the least so far: from there on they only
/// grow, and the largest radii take the most time.
void sweep_radii(Peer& peer, const TruthMesh& truth, double edge,
                 const std::function<void(double radius, const Metrics& metrics, double seconds)>& take);

}  // namespace accuracy
