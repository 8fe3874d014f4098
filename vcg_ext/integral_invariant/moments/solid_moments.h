// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integral_invariant/support/symmetric3.h"
#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// The ten moments ∫1, ∫y, ∫y yᵀ of a piece of solid about the ball's centre; signed, so that pieces add up.
struct SolidMoments {
  double volume = 0;  ///< L^3
  Vec3 first;         ///< L^4
  Symmetric3 second;  ///< L^5

  SolidMoments& operator+=(const SolidMoments& b)
  {
    volume += b.volume;
    first += b.first;
    second += b.second;
    return *this;
  }
  SolidMoments operator*(double s) const { return {volume * s, first * s, second * s}; }
};

inline SolidMoments operator+(SolidMoments a, const SolidMoments& b) { return a += b; }
inline SolidMoments operator-(const SolidMoments& a, const SolidMoments& b) { return a + b * -1.0; }

}  // namespace integral_invariant
