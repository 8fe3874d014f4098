// SPDX-License-Identifier: GPL-3.0-or-later
// The best that one radius for all vertices can do, with the truth in hand.
#pragma once

#include "estimate.h"

namespace accuracy {

struct ConstantRadius {
  double radius = 0;       ///< in average edges of the mesh
  bool bias_free = false;  ///< the bias removed (estimator 2), or offset-free alone (estimator 1)
  Metrics metrics;
};

/// Of the radii 1.5 to 40 ē, geometric, each with and without its bias: the one of least mean error.
ConstantRadius best_constant_radius(const TruthMesh& truth);

}  // namespace accuracy
