// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: the inner loops of polynomial fits (rules: support/vector_lanes.h).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "integral_invariant/support/vector_lanes.h"

namespace integral_invariant {

/// Monomials x^(d−i) y^i by degree: 1; x, y; x², xy, y²; ... A leading part of them makes a polynomial of lower degree.
inline constexpr int largest_degree = 4;
constexpr int coefficient_count(int degree) { return (degree + 1) * (degree + 2) / 2; }
using Coefficients = std::array<double, coefficient_count(largest_degree)>;

/// All that a least squares polynomial depends on, of weighted places (x, y) with heights h.
struct HeightSums {
  std::array<double, coefficient_count(2 * largest_degree)> powers{};  ///< Σ w m, m up to twice the fit's degree
  Coefficients heights{};                                              ///< Σ w m h
  double squares = 0;                                                  ///< Σ w h²
};

/// Places of one fit, a lane each, filled up with places that weigh nothing.
struct HeightPlaces {
  static constexpr std::size_t most_groups = 3, capacity = most_groups * kernel_lanes;

  /// Forgets what was there; `count` places are to be set. \pre count ≤ capacity
  void resize(std::size_t count);
  void set(std::size_t place, double place_x, double place_y, double place_height, double place_weight)
  {
    const std::size_t group = place / kernel_lanes, lane = place % kernel_lanes;
    x[group][lane] = place_x, y[group][lane] = place_y, height[group][lane] = place_height;
    weight[group][lane] = place_weight;
  }
  /// After the last set(): writes the monomials.
  void complete(int degree);

  std::size_t groups = 0;
  Lanes x[most_groups], y[most_groups], height[most_groups], weight[most_groups];
  Lanes monomial[coefficient_count(largest_degree)][most_groups];
};

/// For a fit of the degree for which the places are complete.
HeightSums sums_of(const HeightPlaces& places, int degree);

/// Any number of places of weight 1, filled up with zeros.
struct PlaceColumns {
  struct Group {
    Lanes x, y, height;
  };
  void clear() { count = 0; }
  void add(double x, double y, double height);

  std::size_t count = 0;
  std::vector<Group> groups;  ///< more than it takes for the count, maybe
};

/// Adds places to the sums for a fit of degree 2.
void add_to_quadric_sums(const PlaceColumns& places, HeightSums& sums);

/// Rows of a symmetric matrix from the diagonal on; then of Cholesky's factor U, A = UᵀU, with the inverse of what is
/// on the diagonal.
struct HeightMatrix {
  static constexpr int groups = 2;
  static_assert(coefficient_count(largest_degree) <= groups * int(kernel_lanes), "a row holds all coefficients");

  double at(int row, int column) const { return rows[row][column / int(kernel_lanes)][column % int(kernel_lanes)]; }
  void set(int row, int column, double value)
  {
    rows[row][column / int(kernel_lanes)][column % int(kernel_lanes)] = value;
  }

  Lanes rows[coefficient_count(largest_degree)][groups] = {};
};

/// Right sides b, and then U⁻ᵀ b, a lane each.
struct WhitenedColumns {
  Lanes rows[coefficient_count(largest_degree)] = {};
};

/// Factors as many of the first `count` rows as the places determine, and returns that number.
int factor_as_far_as_determined(HeightMatrix& a, int count);
void whiten(const HeightMatrix& factor, int count, WhitenedColumns& columns);

/// What a fit leaves over, and how it answers to noise.
struct FitQuality {
  double squares = 0;                ///< Σ w off²
  double freedom = 0;                ///< E Σ w off² = σ² · freedom: Σ w − w² mᵀ(AᵀWA)⁻¹m
  double last_squares = 0;           ///< Σ w h² of the terms of the highest degree alone
  double last_freedom = 0;           ///< what noise makes of it, over σ²
  std::array<double, 5> variance{};  ///< of each part, Σ (w mᵀ(AᵀWA)⁻¹ part)²
};

/// \param count coefficients \param last the first monomial of the highest degree
/// \param whitened columns of AᵀW h and of the parts
FitQuality fit_quality(const HeightPlaces& places, int count, int last, const HeightMatrix& factor,
                       const WhitenedColumns& whitened);

}  // namespace integral_invariant
