// SPDX-License-Identifier: GPL-3.0-or-later
// One estimator at every radius of the sweep.
#pragma once

#include <functional>

#include "peers/peer.h"

namespace accuracy {

/// Calls `take(radius, metrics, seconds)` for radii from 1 to 40 times `edge`; once, with radius 0, for an estimator
/// that takes none. The sweep stops once both errors are far above their minima: they only grow from there, and large
/// radii are the slowest.
void sweep_radii(Peer& peer, const TruthMesh& truth, double edge,
                 const std::function<void(double radius, const Metrics& metrics, double seconds)>& take);

}  // namespace accuracy
