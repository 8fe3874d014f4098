// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: line drawings as layers of edges.
#pragma once

#include <vector>

#include "filter_result.h"
#include "integral_invariant/drawing/sheet.h"
#include "integral_invariant/mesh/surface.h"
#include "line_layer.h"

namespace integral_invariant::filter {

/// The lines of all views. Attributes of the vertices: ii_line (number of the line), ii_kind (LineKind as a number),
/// ii_z (significance, the quality too), ii_strength, ii_visible (1 or 0), ii_view (number of the view). `mesh` is the
/// one that `surface` was made of. Outlines are dark, other lines have the colours of ridges and valleys where they are
/// these.
LineLayer drawing_layer(const TriangleMesh& mesh, const Surface& surface, const std::vector<DrawnView>& views,
                        const LineStyle& style);

}  // namespace integral_invariant::filter
