// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: the inner loops of polynomial fits to few places. In: places in columns, a factored system. Out: sums. Cost:
// a microsecond a fit of degree 4.
#include "integral_invariant/curvature/fit_kernels.h"

#include <algorithm>

namespace integral_invariant {

namespace {

constexpr std::size_t lanes = kernel_lanes;

II_VECTOR_CLONES
void write_monomials(HeightPlaces& places, int degree)
{
  for (std::size_t p = 0; p < HeightPlaces::capacity; ++p) places.monomial[0][p] = 1;
  int before = 0, here = 1;
  for (int d = 1; d <= degree; ++d) {
    for (int i = 0; i < d; ++i)
      for (std::size_t p = 0; p < HeightPlaces::capacity; ++p)
        places.monomial[here + i][p] = places.monomial[before + i][p] * places.x[p];
    for (std::size_t p = 0; p < HeightPlaces::capacity; ++p)
      places.monomial[here + d][p] = places.monomial[here - 1][p] * places.y[p];
    before = here;
    here += d + 1;
  }
}

}  // namespace

void HeightPlaces::resize(std::size_t count)
{
  full = (count + lanes - 1) / lanes * lanes;
  for (std::size_t p = count; p < capacity; ++p) set(p, 0, 0, 0, 0);
}

void HeightPlaces::complete(int degree) { write_monomials(*this, degree); }

II_VECTOR_CLONES
void sum_normal_equations(const HeightPlaces& places, int count, HeightMatrix& a, Coefficients& b)
{
  for (int i = 0; i < count; ++i) {
    double weighted[HeightPlaces::capacity], lane[lanes];
    for (std::size_t p = 0; p < HeightPlaces::capacity; ++p) weighted[p] = places.weight[p] * places.monomial[i][p];
    const auto sum_with = [&](const double* column) {
      for (std::size_t j = 0; j < lanes; ++j)
        lane[j] = (weighted[j] * column[j] + weighted[lanes + j] * column[lanes + j]) +
                  weighted[2 * lanes + j] * column[2 * lanes + j];
      return sum_of_lanes(lane);
    };
    static_assert(HeightPlaces::capacity == 3 * lanes, "three groups of places");
    for (int k = 0; k <= i; ++k) a[std::size_t(i)][std::size_t(k)] = sum_with(places.monomial[k]);
    b[std::size_t(i)] = sum_with(places.height);
  }
}

II_VECTOR_CLONES
FitQuality fit_quality(const HeightPlaces& places, int count, int last, const HeightMatrix& factor,
                       const Coefficients& whitened_heights, const std::array<Coefficients, 5>& whitened_parts)
{
  constexpr std::size_t most = coefficient_count(largest_degree), parts = 5;
  double squares[lanes] = {}, freedom[lanes] = {}, last_freedom[lanes] = {}, variance[parts][lanes] = {};
  for (std::size_t first = 0; first < places.full; first += lanes) {
    // z = L⁻¹ m, column by column, and its products as the columns are done.
    double z[most][lanes], fitted[lanes] = {}, leverage[lanes] = {}, below[lanes] = {}, influence[parts][lanes] = {};
    for (int i = 0; i < count; ++i)
      for (std::size_t j = 0; j < lanes; ++j) z[i][j] = places.monomial[i][first + j];
    for (int i = 0; i < count; ++i) {
      if (i == last)
        for (std::size_t j = 0; j < lanes; ++j) below[j] = leverage[j];
      const double* row = factor[std::size_t(i)].data();
      const double inverse = row[i], height = whitened_heights[std::size_t(i)];
      for (std::size_t j = 0; j < lanes; ++j) {
        z[i][j] *= inverse;
        fitted[j] += height * z[i][j];
        leverage[j] += z[i][j] * z[i][j];
      }
      for (std::size_t k = 0; k < parts; ++k) {
        const double part = whitened_parts[k][std::size_t(i)];
        for (std::size_t j = 0; j < lanes; ++j) influence[k][j] += part * z[i][j];
      }
      for (int k = i + 1; k < count; ++k) {
        const double share = row[k];
        for (std::size_t j = 0; j < lanes; ++j) z[k][j] -= share * z[i][j];
      }
    }
    for (std::size_t j = 0; j < lanes; ++j) {
      const double w = places.weight[first + j], off = places.height[first + j] - fitted[j];
      squares[j] += w * off * off;
      freedom[j] += w - w * w * leverage[j];
      last_freedom[j] += w * w * (leverage[j] - below[j]);
      for (std::size_t k = 0; k < parts; ++k) variance[k][j] += (w * influence[k][j]) * (w * influence[k][j]);
    }
  }
  FitQuality quality;
  quality.squares = sum_of_lanes(squares);
  quality.freedom = sum_of_lanes(freedom);
  quality.last_freedom = sum_of_lanes(last_freedom);
  for (int i = last; i < count; ++i)
    quality.last_squares += whitened_heights[std::size_t(i)] * whitened_heights[std::size_t(i)];
  for (std::size_t k = 0; k < parts; ++k) quality.variance[k] = sum_of_lanes(variance[k]);
  return quality;
}

}  // namespace integral_invariant
