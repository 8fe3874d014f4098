// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integral_invariant/support/symmetric3.h"
#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// The ten moments ∫1, ∫y, ∫y yᵀ of a piece of solid about the ball's centre; signed, so that pieces add up.
struct MomentSums {
  double volume = 0;  ///< L^3
  Vec3 first;         ///< L^4
  Symmetric3 second;  ///< L^5

  MomentSums& operator+=(const MomentSums& b)
  {
    volume += b.volume;
    first += b.first;
    second += b.second;
    return *this;
  }
  MomentSums operator*(double s) const { return {volume * s, first * s, second * s}; }
};

inline MomentSums operator+(MomentSums a, const MomentSums& b) { return a += b; }
inline MomentSums operator-(const MomentSums& a, const MomentSums& b) { return a + b * -1.0; }

}  // namespace integral_invariant
