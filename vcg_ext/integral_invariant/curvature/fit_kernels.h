// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: the inner loops of polynomial fits to few places, a place a lane (rules: support/vector_lanes.h).
#pragma once

#include <array>
#include <cstddef>

#include "integral_invariant/curvature/height_polynomial.h"
#include "integral_invariant/support/vector_lanes.h"

namespace integral_invariant {

/// Places of one fit in columns, filled up to full lanes with places that weigh nothing.
struct alignas(64) HeightPlaces {
  static constexpr std::size_t capacity = 24;

  /// Forgets what was there; `count` places are to be set. \pre count ≤ capacity
  void resize(std::size_t count);
  void set(std::size_t place, double place_x, double place_y, double place_height, double place_weight)
  {
    x[place] = place_x, y[place] = place_y, height[place] = place_height, weight[place] = place_weight;
  }
  /// After the last set(): writes the monomials.
  void complete(int degree);

  std::size_t full = 0;  ///< places with those that fill up
  double x[capacity], y[capacity], height[capacity], weight[capacity];
  double monomial[coefficient_count(largest_degree)][capacity];
};

/// Lower triangle of AᵀWA and AᵀW h, of the first `count` monomials.
void sum_normal_equations(const HeightPlaces& places, int count, HeightMatrix& a, Coefficients& b);

/// What a fit leaves over, and how it answers to noise.
struct FitQuality {
  double squares = 0;                ///< Σ w off²
  double freedom = 0;                ///< E Σ w off² = σ² · freedom: Σ w − w² mᵀ(AᵀWA)⁻¹m
  double last_squares = 0;           ///< Σ w h² of the terms of the highest degree alone
  double last_freedom = 0;           ///< what noise makes of it, over σ²
  std::array<double, 5> variance{};  ///< of each part, Σ (w mᵀ(AᵀWA)⁻¹ part)²
};

/// `whitened` are L⁻¹ AᵀW h and L⁻¹ part for the factor L, as HeightSystem leaves it.
/// `last` is the first monomial of the highest degree.
FitQuality fit_quality(const HeightPlaces& places, int count, int last, const HeightMatrix& factor,
                       const Coefficients& whitened_heights, const std::array<Coefficients, 5>& whitened_parts);

}  // namespace integral_invariant
