// SPDX-License-Identifier: GPL-3.0-or-later
// The precision that coordinates were written in. Cost: O(1) a point.
#include "integral_invariant/mesh/coordinate_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace integral_invariant {

namespace {

double largest_magnitude(const std::vector<Vec3>& points)
{
  double largest = 0;
  for (const Vec3& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest;
}

template <class Visit>
bool all_coordinates(const std::vector<Vec3>& points, const Visit& visit)
{
  return std::all_of(points.begin(), points.end(),
                     [&](const Vec3& p) { return visit(p.x) && visit(p.y) && visit(p.z); });
}

/// The least number of significant decimal digits that all coordinates have, up to `most`; or `most` + 1.
int decimal_digits(const std::vector<Vec3>& points, int most, double relative_rounding)
{
  int digits = 1;
  all_coordinates(points, [&](double x) {
    const double magnitude = std::abs(x);
    if (magnitude == 0) return true;
    const double power = std::floor(std::log10(magnitude));
    for (; digits <= most; ++digits) {
      const double scaled = magnitude * std::pow(10.0, digits - 1 - power);
      if (std::abs(scaled - std::round(scaled)) <= relative_rounding * scaled) break;
    }
    return digits <= most;
  });
  return digits;
}

bool are_single(const std::vector<Vec3>& points)
{
  constexpr double largest = std::numeric_limits<float>::max();
  return all_coordinates(points, [](double x) { return std::abs(x) <= largest && double(float(x)) == x; });
}

}  // namespace

double binary_step(const std::vector<Vec3>& points)
{
  const double largest = largest_magnitude(points);
  if (largest == 0) return 0;
  const double epsilon =
      are_single(points) ? double(std::numeric_limits<float>::epsilon()) : std::numeric_limits<double>::epsilon();
  return std::ldexp(epsilon, std::ilogb(largest));
}

double coordinate_step(const std::vector<Vec3>& points)
{
  const double largest = largest_magnitude(points);
  if (largest == 0) return 0;
  const bool is_single = are_single(points);
  // More digits than these are as fine as the binary fraction that holds them.
  const int most = is_single ? 6 : 14;
  const double rounding =
      is_single ? double(std::numeric_limits<float>::epsilon()) : 8 * std::numeric_limits<double>::epsilon();
  const int digits = decimal_digits(points, most, rounding);
  return digits <= most ? std::pow(10.0, std::floor(std::log10(largest)) + 1 - digits) : binary_step(points);
}

}  // namespace integral_invariant
