// SPDX-License-Identifier: GPL-3.0-or-later
// Features: the pieces of curves in the triangles, joined across the edges, and which stretches of a curve are kept.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "integral_invariant/features/topology.h"

namespace integral_invariant {

/// A curve's piece in one triangle.
struct CurveSegment {
  bool exists = false;
  std::array<int, 2> side{};  ///< the sides that it joins
};

struct CurveStep {
  std::int32_t triangle;
  int enter, leave;  ///< sides
};

struct Curve {
  std::vector<CurveStep> steps;
  bool closed = false;
};

/// Joins segments, one or none a triangle, that leave through a side at which the next one enters. Each is in one
/// curve. Cost: O(m). \throw Cancelled
std::vector<Curve> link_curves(const Topology& topology, const std::vector<CurveSegment>& segments,
                               Execution& execution);

/// Elements `first` to `first + count − 1` of a sequence, modulo its length where it is closed.
struct Stretch {
  std::size_t first = 0, count = 0;
};

/// The stretches of kept elements. Up to three elements in a row that are not kept but lie between two that are belong
/// to the stretch: a line that runs along an edge of the mesh flickers. A closed sequence begins at a gap, so that
/// no stretch is cut at its start; without any gap it is one stretch from 0.
std::vector<Stretch> kept_stretches(std::vector<char> keep, bool closed);

}  // namespace integral_invariant
