// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: what the filters can be asked, with every default.
#pragma once

#include <string>

#include "integral_invariant/features/crest_lines.h"
#include "integral_invariant/features/curvature_lines.h"
#include "integral_invariant/features/ridges_valleys.h"
#include "integral_invariant/features/signature.h"
#include "integral_invariant/parameters.h"

namespace integral_invariant::filter {

/// What goes into the quality of the vertices.
enum class Quantity {
  mean = 0,              ///< (κ_max + κ_min) / 2
  gaussian = 1,          ///< κ_max κ_min
  maximal = 2,           ///< κ_max
  minimal = 3,           ///< κ_min
  shape_index = 4,       ///< (2/π) atan2(κ_max + κ_min, κ_max − κ_min), from -1 (cup) to 1 (cap)
  curvedness = 5,        ///< sqrt((κ_max² + κ_min²) / 2)
  radius = 6,            ///< the radius of the vertex's ball
  largest_absolute = 7,  ///< max(|κ_max|, |κ_min|), a magnitude without sign
};
inline constexpr int quantity_count = 8;

/// What is done with the curvatures; the rest of a request is integral_invariant::Parameters.
struct OutputOptions {
  Quantity quality = Quantity::mean;
  bool colorize = true;
  double color_percentile = 95;  ///< how many per cent of the vertices lie inside the colour range, in [50, 100]
  std::string export_file;       ///< PLY with every output; empty: none
};

/// What "Create Principal Direction Layer" draws.
enum class DirectionStyle { traced = 0, segments = 1 };

/// How lines become a layer.
struct LayerOptions {
  DirectionStyle style = DirectionStyle::traced;
  double lift = 0.05;  ///< of the lines over the surface, in average edge lengths
};

/// Everything that the filters can be asked; each reads the parts that its rows of the table write.
struct Request {
  Parameters method;
  OutputOptions output;
  RidgeValleyParameters ridge_valley;
  CrestLineParameters crest;
  DirectionParameters direction;
  LayerOptions layer;
  ReductionParameters signature;
};

}  // namespace integral_invariant::filter
