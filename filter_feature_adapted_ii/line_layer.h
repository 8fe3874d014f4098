// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: lines on the surface as layers of edges.
#pragma once

#include <vector>

#include "filter_result.h"
#include "integral_invariant/features/crest_lines.h"
#include "integral_invariant/features/curvature_lines.h"
#include "integral_invariant/mesh/surface.h"
#include "parameter_list.h"

namespace integral_invariant::filter {

inline constexpr Color first_color{196, 34, 44};   ///< ridges, directions of maximal curvature
inline constexpr Color second_color{32, 84, 190};  ///< valleys, directions of minimal curvature

/// How lines become a layer.
struct LayerOptions {
  double lift = 0.05;  ///< of the lines over the surface, in average edge lengths
};

struct LineStyle {
  bool colorize = true;
  double lift = 0;  ///< above the surface, in average edge lengths
};
LineStyle line_style(const Request& request);

/// The parameters of LayerOptions, and the file that lines are written to.
ParameterSpec line_lift_parameter();
ParameterSpec line_export_parameter();

/// Vertices have the attributes ii_line (number of the line, from 0), ii_kind (1 ridge or maximal, -1 valley or
/// minimal) and ii_strength, which is the quality too: a crest line's strength; along directions, the curvature there.
LineLayer crest_layer(const TriangleMesh& mesh, const Result& result, const std::vector<CrestLine>& lines,
                      const LineStyle& style);
LineLayer curvature_line_layer(const TriangleMesh& mesh, const Result& result, const std::vector<CurvatureLine>& lines,
                               const LineStyle& style);
LineLayer segment_layer(const TriangleMesh& mesh, const Result& result, const std::vector<DirectionSegment>& segments,
                        const LineStyle& style);

}  // namespace integral_invariant::filter
