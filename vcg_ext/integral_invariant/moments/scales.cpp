// SPDX-License-Identifier: GPL-3.0-or-later
// The radii of the scales [Lai09 4.1]. In: the parameters, lengths in the caller's unit. Out: radii in normalised
// units.
#include "integral_invariant/moments/scales.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "integral_invariant/error.h"

namespace integral_invariant {

namespace {

struct Range {
  double low, high;
};

/// Where r_max is automatic it never falls to r_min or under: a larger r_min alone moves the whole ladder up.
Range radius_range(const Parameters& p, double unit)
{
  if (p.radius_choice == RadiusChoice::statistical) {
    // Smaller balls see single triangles; larger ones pay on flat parts alone, and their cost grows with the radius.
    constexpr double smallest = 1.5, largest = 16;
    const double low = p.r_min > 0 ? p.r_min / unit : smallest;
    return {low, p.r_max > 0 ? p.r_max / unit : std::max(largest, 2 * low)};
  }
  const double low = p.r_min > 0 ? p.r_min / unit : 1;
  const double high = p.r_max > 0 ? p.r_max / unit : (low < p.scales ? double(p.scales) : p.scales * low);
  return {low, high};
}

[[noreturn]] void reject_range(const Range& range, double unit)
{
  std::ostringstream text;
  text << "The smallest radius must be under the largest: r_min is " << range.low * unit << " and r_max is "
       << range.high * unit << " (the average edge length is " << unit
       << "). Enlarge r_max, reduce r_min, or set either to 0 for its automatic value.";
  throw ParameterError(text.str());
}

/// Smaller balls see rounding alone, larger ones overflow; in average edge lengths.
constexpr double smallest_radius = 1e-3, largest_radius = 1e6;
/// Of neighbouring radii; nearer ones cannot be told apart by what they see.
constexpr double least_relative_gap = 1e-3;

void require_radius(const char* name, double radius, double unit)
{
  if (radius >= smallest_radius && radius <= largest_radius) return;
  std::ostringstream text;
  text << "The radius '" << name << "' is " << radius * unit << ", but must be from " << smallest_radius * unit
       << " to " << largest_radius * unit << " (" << smallest_radius << " to " << largest_radius
       << " average edge lengths). Change it, or set it to 0 for its automatic value.";
  throw ParameterError(text.str());
}

void require_gaps(const Range& range, int scales, double unit)
{
  if (range.high - range.low >= least_relative_gap * (scales - 1) * range.low) return;
  std::ostringstream text;
  text << scales << " scales do not fit between r_min = " << range.low * unit << " and r_max = " << range.high * unit
       << ": radii must differ by a thousandth at least. Enlarge r_max or reduce scales.";
  throw ParameterError(text.str());
}

}  // namespace

std::vector<double> scale_radii(const Parameters& p, double unit)
{
  const Range range = radius_range(p, unit);
  require_radius("r_min", range.low, unit);
  require_radius("r_max", range.high, unit);
  if (p.radius_choice == RadiusChoice::fixed) {
    if (p.radius > 0) {
      require_radius("radius", p.radius / unit, unit);
      return {p.radius / unit};
    }
    if (range.high < range.low) reject_range(range, unit);
    return {(range.low + range.high) / 2};
  }
  if (p.scales == 1) return {range.low};
  if (!(range.low < range.high)) reject_range(range, unit);
  require_gaps(range, p.scales, unit);

  std::vector<double> radii(p.scales);
  for (int i = 0; i < p.scales; ++i) {
    const double t = double(i) / (p.scales - 1);
    const bool is_linear = p.spacing == ScaleSpacing::linear && p.radius_choice != RadiusChoice::statistical;
    radii[i] = is_linear ? range.low + t * (range.high - range.low) : range.low * std::pow(range.high / range.low, t);
  }
  radii.back() = range.high;
  return radii;
}

}  // namespace integral_invariant
