// SPDX-License-Identifier: GPL-3.0-or-later
// Quality quantities from principal curvatures, percentiles, colours.
#include "quality.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/support/pi.h"

namespace integral_invariant::filter {

namespace {

struct QuantityFacts {
  const char *label, *key, *unit;
  bool is_signed;
};

constexpr std::array<QuantityFacts, quantity_count> facts{{
    {"mean curvature", "mean", "1/L", true},
    {"Gaussian curvature", "gaussian", "1/L^2", true},
    {"maximal curvature", "maximal", "1/L", true},
    {"minimal curvature", "minimal", "1/L", true},
    {"shape index", "shape_index", "", true},
    {"curvedness", "curvedness", "1/L", false},
    {"radius", "radius", "L", false},
    {"largest absolute curvature", "largest_absolute", "1/L", false},
}};

const QuantityFacts& facts_of(Quantity quantity) { return facts[static_cast<std::size_t>(quantity)]; }

double value_of(Quantity quantity, double k_max, double k_min, double radius)
{
  switch (quantity) {
    case Quantity::mean:
      return (k_max + k_min) / 2;
    case Quantity::gaussian:
      return k_max * k_min;
    case Quantity::maximal:
      return k_max;
    case Quantity::minimal:
      return k_min;
    case Quantity::shape_index:
      return 2 / pi * std::atan2(k_max + k_min, k_max - k_min);
    case Quantity::curvedness:
      return std::hypot(k_max, k_min) / std::sqrt(2.0);
    case Quantity::radius:
      return radius;
    case Quantity::largest_absolute:
      return std::max(std::abs(k_max), std::abs(k_min));
  }
  return 0;
}

/// Interpolated between the two neighbours in order.
double percentile_of_sorted(const std::vector<double>& sorted, double percent)
{
  if (sorted.empty()) return 0;
  const double position = percent / 100 * static_cast<double>(sorted.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(position), sorted.size() - 1);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (position - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// Colours at equal distances along the range.
template <std::size_t N>
Color interpolated(const std::array<Color, N>& stops, double t)
{
  const double position = t * (N - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(position), N - 2);
  const double part = position - static_cast<double>(i);
  Color color;
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<std::uint8_t>(std::lround(stops[i][c] + part * (stops[i + 1][c] - stops[i][c])));
  return color;
}

// Lightness rises evenly along the second map and is symmetric in the first, so both can be read in grey.
constexpr std::array<Color, 5> diverging{
    {{33, 62, 154}, {108, 151, 222}, {245, 245, 245}, {226, 125, 96}, {160, 18, 36}}};
constexpr std::array<Color, 5> sequential{
    {{62, 20, 92}, {52, 83, 148}, {28, 138, 134}, {102, 192, 82}, {250, 228, 60}}};

}  // namespace

std::vector<double> quantity_values(const Result& result, Quantity quantity)
{
  std::vector<double> values(result.kappa_max.size());
  for (std::size_t v = 0; v < values.size(); ++v)
    values[v] = value_of(quantity, result.kappa_max[v], result.kappa_min[v], result.radius[v]);
  return values;
}

bool is_signed(Quantity quantity) { return facts_of(quantity).is_signed; }
const char* quantity_label(Quantity quantity) { return facts_of(quantity).label; }
const char* quantity_key(Quantity quantity) { return facts_of(quantity).key; }
const char* quantity_unit(Quantity quantity) { return facts_of(quantity).unit; }

Statistics statistics(std::vector<double> values)
{
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return {values.front(), percentile_of_sorted(values, 5), percentile_of_sorted(values, 50),
          percentile_of_sorted(values, 95), values.back()};
}

double percentile(std::vector<double> values, double percent)
{
  std::sort(values.begin(), values.end());
  return percentile_of_sorted(values, percent);
}

ColorRange color_range(const std::vector<double>& values, Quantity quantity, double percent)
{
  if (quantity == Quantity::shape_index) return {-1, 1};
  std::vector<double> sorted = values;
  if (is_signed(quantity)) {
    for (double& value : sorted) value = std::abs(value);
    const double largest = percentile(std::move(sorted), percent);
    return {-largest, largest};
  }
  std::sort(sorted.begin(), sorted.end());
  const double left_out = (100 - percent) / 2;
  return {percentile_of_sorted(sorted, left_out), percentile_of_sorted(sorted, 100 - left_out)};
}

Color color_of(double value, const ColorRange& range, Quantity quantity)
{
  const double width = range.high - range.low;
  const double t = width > 0 ? std::clamp((value - range.low) / width, 0.0, 1.0) : 0.5;
  return is_signed(quantity) ? interpolated(diverging, t) : interpolated(sequential, t);
}

}  // namespace integral_invariant::filter
