// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: polynomial heights. In: sums over places on a tangent plane. Out: coefficients, their variances, curvature.
// Cost: O(c³) a fit of c coefficients, half a microsecond for degree 4. Source: Cholesky's method; the shape operator
// of a graph.
#include "integral_invariant/jets/height_polynomial.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

namespace {

/// Place in the lists of x^(d−i) y^i, by the degree d and i.
constexpr int place_of(int degree, int i) { return degree * (degree + 1) / 2 + i; }

/// Σ w m_i m_j for j ≥ i.
void set_normal_matrix(const HeightSums& sums, int degree, HeightMatrix& a)
{
  for (int d = 0; d <= degree; ++d)
    for (int i = 0; i <= d; ++i) {
      for (int e = d; e <= degree; ++e)
        for (int j = 0; j <= e; ++j)
          a.set(place_of(d, i), place_of(e, j), sums.powers[std::size_t(place_of(d + e, i + j))]);
    }
}

void set_right_sides(const HeightSums& sums, int count, WhitenedColumns& columns)
{
  for (int i = 0; i < count; ++i) columns.rows[i][heights_column] = sums.heights[std::size_t(i)];
  const auto set_part = [&](int monomial, HeightPart part, double value) {
    columns.rows[monomial][part_column(part)] = value;
  };
  constexpr int x = place_of(1, 0), y = place_of(1, 1), xx = place_of(2, 0), xy = place_of(2, 1), yy = place_of(2, 2);
  set_part(x, slope_x_part, 1);
  set_part(y, slope_y_part, 1);
  set_part(xx, mean_part, 1);
  set_part(yy, mean_part, 1);
  set_part(xx, deviator_a_part, 1);
  set_part(yy, deviator_a_part, -1);
  set_part(xy, deviator_b_part, 1);
}

}  // namespace

HeightFit::HeightFit(const HeightSums& sums, int degree)
    : degree_(degree),
      sum_of_squares_(sums.squares),
      factor_(coefficient_count(degree)),
      whitened_(coefficient_count(degree))
{
  set_normal_matrix(sums, degree, factor_);
  // What is left of a column when the others have explained it: with less, the places hardly tell it. An even disc
  // leaves 0.05 of x⁴ and more of the others up to there.
  constexpr int usual_degree = 4;
  constexpr double usual_share = 1e-3, share_of_high_degrees = 1e-5;
  const int rank = factor_as_far_as_determined(factor_, coefficient_count(degree),
                                               degree <= usual_degree ? usual_share : share_of_high_degrees);
  while (degree_ > 0 && coefficient_count(degree_) > rank) --degree_;
  set_right_sides(sums, coefficient_count(degree_), whitened_);
  whiten(factor_, coefficient_count(degree_), whitened_);
}

Coefficients HeightFit::coefficients() const
{
  const int count = coefficient_count(degree_);
  Coefficients c{};
  for (int i = 0; i < count; ++i) c[std::size_t(i)] = whitened_.rows[i][heights_column];
  for (int i = count; i-- > 0;) {
    double rest = c[std::size_t(i)];
    for (int k = i + 1; k < count; ++k) rest -= factor_.at(i, k) * c[std::size_t(k)];
    c[std::size_t(i)] = rest * factor_.at(i, i);
  }
  return c;
}

double HeightFit::squares() const
{
  return std::max(0.0, sum_of_squares_ - column_product(heights_column, heights_column));
}

double HeightFit::covariance(HeightPart a, HeightPart b) const
{
  return column_product(part_column(a), part_column(b));
}

double HeightFit::column_product(std::size_t a, std::size_t b) const
{
  double sum = 0;
  for (int i = 0; i < coefficient_count(degree_); ++i) sum += whitened_.rows[i][a] * whitened_.rows[i][b];
  return sum;
}

FitQuality HeightFit::quality(const HeightPlaces& places) const
{
  return fit_quality(places, coefficient_count(degree_), coefficient_count(degree_ - 1), factor_, whitened_);
}

HeightFrame::HeightFrame(const Vec3& up) : normal(up), x(any_orthogonal(up)), y(cross(up, x)) {}

CurvatureTensor graph_curvature(const Coefficients& c, const HeightFrame& frame, double unit)
{
  const double slope_x = c[1] / unit, slope_y = c[2] / unit;
  const double stretch = std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
  const Vec3 normal = (frame.normal - frame.x * slope_x - frame.y * slope_y) * (1 / stretch);
  // Of f = z − h: the tangential part of its Hessian over |∇f|.
  const Symmetric3 hessian =
      outer(frame.x) * (-2 * c[3]) + symmetric_outer(frame.x, frame.y) * -c[4] + outer(frame.y) * (-2 * c[5]);
  return {tangential_part(hessian * (1 / (unit * unit * stretch)), normal), normal, 1};
}

}  // namespace integral_invariant
