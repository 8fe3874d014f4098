// SPDX-License-Identifier: GPL-3.0-or-later
// Features: the pieces of crest lines in the triangles, joined to lines.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "integral_invariant/features/topology.h"

namespace integral_invariant {

/// The piece of the curve "derivative = 0" in one triangle.
struct CrestSegment {
  bool exists = false;
  bool extremum = false;      ///< a maximum, and of the larger curvature: what a crest line is made of
  std::array<int, 2> side{};  ///< the sides that it joins
  double curvature = 0;       ///< κ of its kind, 1/ē
};

struct CrestStep {
  std::int32_t triangle;
  int enter, leave;  ///< sides
};

struct CrestChain {
  std::vector<CrestStep> steps;
  bool closed = false;
};

/// Joins the segments across shared edges, and cuts out the parts that are extrema. Up to three segments in a row that
/// are none are kept between two that are: a line that runs along an edge of the mesh flickers.
std::vector<CrestChain> link_segments(const Topology& topology, const std::vector<CrestSegment>& segments,
                                      Execution& execution);

}  // namespace integral_invariant
