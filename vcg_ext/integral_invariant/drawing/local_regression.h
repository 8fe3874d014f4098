// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: weighted polynomial regression over the neighbourhood of a vertex.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "integral_invariant/ball_curvature/tangent_frame.h"
#include "integral_invariant/mesh/surface.h"

namespace integral_invariant {

/// Collects the vertices around a vertex: those within a distance, along edges that do not leave it, whose normal is
/// within 60 degrees. One a worker: it holds a mark for every vertex.
class NeighbourhoodWalk {
 public:
  NeighbourhoodWalk(const Surface& surface, const std::vector<Vec3>& normals);

  /// The vertex itself first, then in the order in which they are met. Valid until the next call.
  const std::vector<std::int32_t>& around(std::int32_t vertex, double distance);

 private:
  const Surface& surface_;
  const std::vector<Vec3>& normals_;
  std::vector<std::int32_t> mark_;  ///< the last vertex around which each was met
  std::vector<std::int32_t> found_;
};

/// The place of `q` in the tangent plane at `p`.
inline std::array<double, 2> tangential_place(const Vec3& p, const Vec3& q, const TangentFrame& frame)
{
  return {dot(q - p, frame.u), dot(q - p, frame.v)};
}

/// A quantity about the origin: value + slope[0] x + slope[1] y + square[0] x² + square[1] xy + square[2] y².
struct LocalFit {
  double value = 0;
  std::array<double, 2> slope{};
  std::array<double, 3> square{};

  double operator()(const std::array<double, 2>& place) const
  {
    const auto [x, y] = place;
    return value + x * (slope[0] + square[0] * x + square[1] * y) + y * (slope[1] + square[2] * y);
  }
};

/// Variances of a fit's value and slope, in units of (variance of a datum) / (sum of the weights), if each datum's
/// variance is inverse to its weight. With Gaussian weights exp(−d²/(2R²)) on the whole plane the value's is 1 for a
/// linear and 2 for a quadratic function, and the slope's 1/R² for both; at a boundary they are larger.
struct FitVariance {
  double value = 0, slope = 0;
};

/// Weighted least squares of several quantities over the same places, by polynomials of degree 1 or 2.
template <int degree, std::size_t quantities>
class LocalRegression {
  static_assert(degree == 1 || degree == 2);

 public:
  static constexpr int terms = degree == 1 ? 3 : 6;

  void add(const std::array<double, 2>& place, double weight, const std::array<double, quantities>& values);

  /// Fits of all quantities; by a polynomial of lower degree where the places do not tell this one.
  std::array<LocalFit, quantities> solve();

  /// Of the fits that solve() has made.
  FitVariance variance() const { return variance_; }

 private:
  using Column = std::array<double, std::size_t(terms)>;

  int factorise();
  Column solved(Column right, int count) const;

  std::array<Column, std::size_t(terms)> normal_{};  ///< lower triangle; then that of its Cholesky factor
  std::array<Column, quantities> right_{};
  double weights_ = 0;
  FitVariance variance_;
};

/// Standard errors of a local fit of `degree` to a quantity of standard error 1 whose errors are correlated over the
/// distance `correlation` (ℓ) as exp(−d²/(2ℓ²)). With Gaussian weights of the width R on the plane and B = ℓ² + 2R² the
/// variances are, linear: value ℓ²/B, quadratic: value ℓ² (1/B + 2R²/B² + 2R⁴/B³), slope of both: ℓ²/B². R follows from
/// the slope's `variance`; where the places are not all around, the value's is larger by what its own one tells.
struct FitError {
  double value = 0, slope = 0;
};
FitError fit_error(int degree, double correlation, const FitVariance& variance);

template <int degree, std::size_t quantities>
void LocalRegression<degree, quantities>::add(const std::array<double, 2>& place, double weight,
                                              const std::array<double, quantities>& values)
{
  Column row{};
  row[0] = 1;
  row[1] = place[0];
  row[2] = place[1];
  if constexpr (degree == 2) {
    row[3] = place[0] * place[0];
    row[4] = place[0] * place[1];
    row[5] = place[1] * place[1];
  }
  weights_ += weight;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const double weighted = weight * row[i];
    for (std::size_t j = 0; j <= i; ++j) normal_[i][j] += weighted * row[j];
    for (std::size_t q = 0; q < quantities; ++q) right_[q][i] += weighted * values[q];
  }
}

/// Cholesky's factor in place. Returns how many terms the places tell: 6, 3, 1 or 0.
template <int degree, std::size_t quantities>
int LocalRegression<degree, quantities>::factorise()
{
  constexpr double least_pivot = 1e-6;  // of the diagonal: less is rounding
  const auto lower_degree = [](int i) { return i >= 3 ? 3 : i >= 1 ? 1 : 0; };
  for (int i = 0; i < terms; ++i) {
    const double diagonal = normal_[std::size_t(i)][std::size_t(i)];
    for (int j = 0; j <= i; ++j) {
      auto &row = normal_[std::size_t(i)], &other = normal_[std::size_t(j)];
      double sum = row[std::size_t(j)];
      for (int k = 0; k < j; ++k) sum -= row[std::size_t(k)] * other[std::size_t(k)];
      if (j < i)
        row[std::size_t(j)] = sum / other[std::size_t(j)];
      else if (sum > least_pivot * diagonal)
        row[std::size_t(i)] = std::sqrt(sum);
      else
        return lower_degree(i);
    }
  }
  return terms;
}

template <int degree, std::size_t quantities>
typename LocalRegression<degree, quantities>::Column LocalRegression<degree, quantities>::solved(Column right,
                                                                                                 int count) const
{
  const std::size_t n = std::size_t(count);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) right[i] -= normal_[i][k] * right[k];
    right[i] /= normal_[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) right[i] -= normal_[k][i] * right[k];
    right[i] /= normal_[i][i];
  }
  return right;
}

template <int degree, std::size_t quantities>
std::array<LocalFit, quantities> LocalRegression<degree, quantities>::solve()
{
  std::array<LocalFit, quantities> fits;
  const int count = factorise();
  if (count == 0) return fits;
  const auto unit = [](std::size_t i) {
    Column column{};
    column[i] = 1;
    return column;
  };
  variance_.value = weights_ * solved(unit(0), count)[0];
  if (count > 1) variance_.slope = weights_ * (solved(unit(1), count)[1] + solved(unit(2), count)[2]) / 2;
  for (std::size_t q = 0; q < quantities; ++q) {
    const Column c = solved(right_[q], count);
    fits[q].value = c[0];
    if (count > 1) fits[q].slope = {c[1], c[2]};
    if constexpr (degree == 2)
      if (count > 3) fits[q].square = {c[3], c[4], c[5]};
  }
  return fits;
}

}  // namespace integral_invariant
