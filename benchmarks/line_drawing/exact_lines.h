// SPDX-License-Identifier: GPL-3.0-or-later
// The exact lines of a shape: zeros of closed forms on a fine grid over its parameters.
#pragma once

#include <vector>

#include "integral_invariant/drawing/surface_line.h"
#include "shapes.h"

namespace line_benchmark {

using integral_invariant::LineKind;

struct ExactSegment {
  Vec3 a, b;
};

/// Contours (all of them, seen or hidden), suggestive contours and highlights of the front, ridges, valleys and
/// demarcating curves; seen from `toward`.
std::vector<ExactSegment> exact_lines(const Shape& shape, LineKind kind, const Vec3& toward);

}  // namespace line_benchmark
