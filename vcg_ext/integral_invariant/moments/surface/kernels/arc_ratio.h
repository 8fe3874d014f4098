// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: θ/sin θ of arcs as a series, for the inner loops (no branches, no calls; see clip.h).
#pragma once

#include <array>
#include <cmath>

namespace integral_invariant {

/// Coefficients of θ/sin θ as a series in t = sin²(θ/2): Π 2j/(2j+1). One more, 0, to fill up pairs.
template <int terms>
constexpr std::array<double, terms + 1> angle_factors()
{
  std::array<double, terms + 1> factor{};
  factor[0] = 1;
  for (int k = 1; k < terms; ++k) factor[k] = factor[k - 1] * (2.0 * k) / (2.0 * k + 1);
  return factor;
}

/// The series; even and odd powers apart, as one chain is slow.
template <int terms>
inline double angle_ratio(double t)
{
  constexpr std::array<double, terms + 1> factor = angle_factors<terms>();
  constexpr int last_even = (terms - 1) / 2 * 2;
  const double t2 = t * t;
  double even = factor[last_even], odd = factor[last_even + 1];
#pragma GCC unroll 16
  for (int k = last_even - 2; k >= 0; k -= 2) {
    even = even * t2 + factor[k];
    odd = odd * t2 + factor[k + 1];
  }
  return even + t * odd;
}

/// The same for any t < 1: halving the angle twice brings t under 0.147, where 17 terms are exact to 1e-15.
inline double any_angle_ratio(double t)
{
  // Not fmax, which compilers do not turn into a vector instruction.
  const double cosine2 = 1 - t, cosine = std::sqrt(cosine2 > 1e-15 ? cosine2 : 1e-15), half = t / (2 * (1 + cosine));
  const double half_cosine = std::sqrt(1 - half), quarter = half / (2 * (1 + half_cosine));
  return angle_ratio<17>(quarter) / (cosine * half_cosine);
}

}  // namespace integral_invariant
