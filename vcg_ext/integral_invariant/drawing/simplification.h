// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: polylines with as few points as a tolerance permits.
#pragma once

#include "integral_invariant/drawing/sheet.h"

namespace integral_invariant {

/// The line through some of its points, to which all others are nearer than `tolerance` (Douglas and Peucker 1973).
/// Cost: O(n log n) for usual lines.
PaperLine simplified(const PaperLine& line, double tolerance);

}  // namespace integral_invariant
