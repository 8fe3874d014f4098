// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the spherical part of a ball's boundary.
#include "integral_invariant/moments/surface/spherical_region.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/support/pi.h"

namespace integral_invariant {

void ArcSums::add(const Vec3& a, const Vec3& b, double times, const Vec3& pole)
{
  const ArcTerms arc = great_arc(a, b);
  terms_.first += arc.first * times;
  terms_.second += arc.second * times;
  half_area_ += 0.5 * times * spherical_triangle_area(pole, a, b);
}

void ArcSums::add(const ArcTerms& terms, std::complex<double> half_area)
{
  terms_.first += terms.first;
  terms_.second += terms.second;
  half_area_ += std::arg(half_area);
}

ArcSums& ArcSums::operator+=(const ArcSums& b)
{
  terms_.first += b.terms_.first;
  terms_.second += b.terms_.second;
  half_area_ += b.half_area_;
  return *this;
}

BallMoments ball_moments(const SolidMoments& flux, const ArcTerms& arcs, double half_area, double radius)
{
  const double r3 = radius * radius * radius;
  // 3 flux / r³ + area is 4π times the solid share of the ball, and the area is known modulo 4π.
  const double flux_area = 3 * flux.volume / r3;
  double solid = std::fmod(flux_area - 2 * half_area, 4 * pi);
  if (!std::isfinite(solid)) return {};
  if (solid < 0) solid += 4 * pi;
  // Nothing and the whole ball differ by rounding only (a sheet with two sides, say): nothing, which has no direction.
  constexpr double rounding = 1e-9;
  if (solid > 4 * pi - rounding) solid -= 4 * pi;
  const double area = solid - flux_area;

  BallMoments moments;
  moments.volume = std::clamp(solid * r3 / 3, 0.0, 4 * pi / 3 * r3);
  moments.first = flux.first - arcs.first * (r3 * radius / 4);
  moments.second = flux.second + (Symmetric3::identity(area / 3) - arcs.second) * (r3 * radius * radius / 5);
  return moments;
}

}  // namespace integral_invariant
