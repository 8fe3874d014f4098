// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: the inner loops of polynomial fits (rules: support/simd.h).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "integral_invariant/support/simd.h"

namespace integral_invariant {

/// Monomials x^(d−i) y^i by degree: 1; x, y; x², xy, y²; ... A leading part of them makes a polynomial of lower degree.
inline constexpr int largest_degree = 6;
constexpr int coefficient_count(int degree) { return (degree + 1) * (degree + 2) / 2; }
using Coefficients = std::array<double, coefficient_count(largest_degree)>;

/// What the curvature of a level graph is made of, linear in the coefficients: H, the components of K − H I, the
/// slopes.
enum HeightPart { mean_part, deviator_a_part, deviator_b_part, slope_x_part, slope_y_part, height_part_count };

/// All that a least squares polynomial depends on, of weighted places (x, y) with heights h.
struct HeightSums {
  std::array<double, coefficient_count(2 * largest_degree)> powers{};  ///< Σ w m, m up to twice the fit's degree
  Coefficients heights{};                                              ///< Σ w m h
  double squares = 0;                                                  ///< Σ w h²
};

/// Places of one fit, a lane each, filled up with places that weigh nothing.
struct HeightPlaces {
  static constexpr std::size_t most_groups = 5, capacity = most_groups * kernel_lanes;

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
  static constexpr int most_groups = 4;
  static_assert(coefficient_count(largest_degree) <= most_groups * int(kernel_lanes), "a row holds all coefficients");

  /// Zeros, of as many rows and columns; what is beyond them is nothing.
  explicit HeightMatrix(int count);

  double at(int row, int column) const { return rows[row][column / int(kernel_lanes)][column % int(kernel_lanes)]; }
  void set(int row, int column, double value)
  {
    rows[row][column / int(kernel_lanes)][column % int(kernel_lanes)] = value;
  }

  Lanes rows[coefficient_count(largest_degree)][most_groups];
};

/// Right sides b, and then U⁻ᵀ b, a lane each: AᵀW h, then the parts.
struct WhitenedColumns {
  explicit WhitenedColumns(int count);

  Lanes rows[coefficient_count(largest_degree)];
};
inline constexpr std::size_t heights_column = 0;
constexpr std::size_t part_column(std::size_t part) { return 1 + part; }
static_assert(part_column(height_part_count) <= kernel_lanes, "a column a lane");

/// Factors as many of the first `count` rows as the places determine, and returns that number.
/// \param least_share of a column's square that the columns before it must leave
int factor_as_far_as_determined(HeightMatrix& a, int count, double least_share);
void whiten(const HeightMatrix& factor, int count, WhitenedColumns& columns);

/// What a fit leaves over, and how it answers to noise.
struct FitQuality {
  double squares = 0;             ///< Σ w off²
  double freedom = 0;             ///< E Σ w off² = σ² · freedom: Σ w − w² mᵀ(AᵀWA)⁻¹m
  double top_degree_squares = 0;  ///< Σ w h² of the terms of the highest degree alone
  double top_degree_dof = 0;      ///< what noise makes of it, over σ²
  std::array<double, height_part_count> variance{};  ///< of each part, Σ (w mᵀ(AᵀWA)⁻¹ part)²
};

/// \param count coefficients \param last the first monomial of the highest degree
FitQuality fit_quality(const HeightPlaces& places, int count, int last, const HeightMatrix& factor,
                       const WhitenedColumns& whitened);

}  // namespace integral_invariant
