// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: the quantities that go into the quality of the vertices, their statistics and colours.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "integral_invariant/result.h"

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

/// The quantity of every vertex, in the order of the result. Units: 1/L for mean, maximal, minimal, curvedness and
/// largest absolute, 1/L² for Gaussian, none for the shape index, L for the radius.
std::vector<double> quantity_values(const Result& result, Quantity quantity);

/// Whether the sign of the quantity means something, so that its colours are symmetric about zero.
bool is_signed(Quantity quantity);

/// Short name for logs and legends: "mean curvature".
const char* quantity_label(Quantity quantity);
/// The same as part of an identifier: "mean".
const char* quantity_key(Quantity quantity);
/// "1/L", "1/L^2", "L" or "".
const char* quantity_unit(Quantity quantity);

/// Smallest, 5th percentile, median, 95th percentile and largest value; zeros where there is no value.
struct Statistics {
  double minimum = 0, p5 = 0, median = 0, p95 = 0, maximum = 0;
};
Statistics statistics(std::vector<double> values);

/// The value that `percent` of the values do not exceed, interpolated linearly between neighbours in order; 0 of none.
double percentile(std::vector<double> values, double percent);

struct ColorRange {
  double low = 0, high = 0;
};

/// The values at the two ends of the colours. Signed quantities: ±the percentile of |value|, so that zero stands in the
/// middle; the shape index: always ±1. Others: as many vertices are left out below as above.
ColorRange color_range(const std::vector<double>& values, Quantity quantity, double percent);

using Color = std::array<std::uint8_t, 3>;

/// Signed quantities: blue (low), white (middle), red (high). Others: dark violet, blue, green, yellow.
/// Values outside the range take the colour of its end; an empty range has the middle colour.
Color color_of(double value, const ColorRange& range, Quantity quantity);

}  // namespace integral_invariant::filter
