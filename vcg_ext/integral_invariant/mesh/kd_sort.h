// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: an order of places in which runs of consecutive ones are compact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "integral_invariant/support/execution.h"
#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// A place, in single precision (it only decides the order), and what stands there.
struct SortItem {
  float place[3];
  std::uint32_t index;
};

/// The longest stretch of items that are ordered among each other, in runs: beyond it they stay as they come.
constexpr std::size_t longest_segment = std::size_t(1) << 17;

/// Orders the items, which come so that those of a stretch are near each other, so that every run of run·2^j of them
/// that begins at a multiple of its length lies in a box of its own: halves of halves along the longest side. Unlike
/// along a space-filling curve, no run has outliers. Cost O(n), on all workers. \throw Cancelled
void kd_sort(std::vector<SortItem>& items, std::size_t run, Execution& execution);

}  // namespace integral_invariant
