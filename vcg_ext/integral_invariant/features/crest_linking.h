// SPDX-License-Identifier: GPL-3.0-or-later
// Features: the pieces of crest lines in the triangles, joined to lines.
#pragma once

#include <vector>

#include "integral_invariant/features/curve_linking.h"

namespace integral_invariant {

/// The piece of the curve "derivative = 0" in one triangle.
struct CrestSegment {
  CurveSegment piece;
  bool extremum = false;  ///< a maximum, and of the larger curvature: what a crest line is made of
  double curvature = 0;   ///< κ of its kind, 1/ē
};

/// Joins the segments across shared edges, and cuts out the parts that are extrema (see kept_stretches()).
std::vector<Curve> link_segments(const Topology& topology, const std::vector<CrestSegment>& segments,
                                 Execution& execution);

}  // namespace integral_invariant
