// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 0: single vertices that stand out of the surface, as scanners leave them.
#pragma once

#include <cstdint>
#include <vector>

#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// A vertex and where it would be on the surface of the vertices around it; normalised units.
struct Outlier {
  std::uint32_t vertex;
  Vec3 place;
};

/// A vertex is an outlier where it stands out by more than a quarter of its edges, and by far more than any noise there
/// would let it: more than 4.5 times what three quarters of the vertices within two rings stand out of their own
/// neighbours (it does not count among these), and more than 6 standard deviations of what a quadric through these
/// vertices leaves over. At most one other
/// vertex within the two rings may stand out half as far, and is then left out of both measures: creases and corners,
/// where more do, are no outliers. Cost O(n).
std::vector<Outlier> find_outliers(const Surface& surface, Execution& execution);

}  // namespace integral_invariant
