// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: an order of places in which runs of consecutive ones are compact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "integral_invariant/support/execution.h"
#include "integral_invariant/support/vec3.h"

namespace integral_invariant {

/// A place, in single precision (it only decides the order), and what stands there.
struct PlacedItem {
  float place[3];
  std::uint32_t index;
};

/// Orders the items so that every run of run·2^j of them that begins at a multiple of its length lies in a box of its
/// own: halves of halves along the longest side. Unlike along a space-filling curve, no run has outliers.
/// Cost O(n log n), on all workers.
void order_compactly(std::vector<PlacedItem>& items, std::size_t run, Execution& execution);

}  // namespace integral_invariant
