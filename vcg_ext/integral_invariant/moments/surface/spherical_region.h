// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the spherical part of a ball's boundary, {directions that point into the solid at distance r}.
#pragma once

#include <complex>

#include "integral_invariant/moments/engine.h"
#include "integral_invariant/moments/solid_moments.h"
#include "integral_invariant/moments/surface/spherical_moments.h"

namespace integral_invariant {

/// Sums the great arcs of the curve in which the surface leaves the ball, each in the direction in which the surface's
/// boundary passes it (the spherical region is on its right).
///
/// The area is the sum of the spherical triangles of a fixed pole and the arcs, modulo 4π. They are kept as a product
/// of complex numbers of half their argument, so that no arc needs an arctangent.
class ArcSums {
 public:
  /// Arc between the unit vectors a and b, `times` often (negative: the other way).
  void add(const Vec3& a, const Vec3& b, double times, const Vec3& pole);
  /// Terms summed elsewhere; `half_area` is a complex number whose argument is half of the area.
  void add(const ArcTerms& terms, std::complex<double> half_area);
  ArcSums& operator+=(const ArcSums& b);

  const ArcTerms& terms() const { return terms_; }
  double half_area() const { return half_area_; }

 private:
  ArcTerms terms_;
  double half_area_ = 0;
};

/// Moments of the ball from the sum of all fluxes through its plane pieces and the arcs of its spherical part.
/// `half_area` is half of the area about the pole of all arcs; of the values that it allows modulo 2π, the one is taken
/// that gives a volume between nothing and the whole ball.
BallMoments ball_moments(const SolidMoments& flux, const ArcTerms& arcs, double half_area, double radius);

}  // namespace integral_invariant
