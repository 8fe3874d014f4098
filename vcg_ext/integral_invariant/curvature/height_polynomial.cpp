// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: polynomial heights. In: places over a tangent plane. Out: coefficients, curvature. Cost: O(c²) a place,
// O(c³) a fit of c coefficients: 1 µs for degree 3, 3 µs for degree 4. Source: Cholesky's method; the shape operator of
// a graph.
#include "integral_invariant/curvature/height_polynomial.h"

#include <cmath>

#include "integral_invariant/curvature/fit_kernels.h"

namespace integral_invariant {

void monomials(double x, double y, int degree, Coefficients& m)
{
  m[0] = 1;
  int before = 0, here = 1;
  for (int d = 1; d <= degree; ++d) {
    for (int i = 0; i < d; ++i) m[here + i] = m[before + i] * x;
    m[here + d] = m[here - 1] * y;
    before = here;
    here += d + 1;
  }
}

HeightSystem::HeightSystem(const HeightPlaces& places, int degree)
{
  sum_normal_equations(places, coefficient_count(degree), a_, b_);
}

void HeightSystem::add(const Coefficients& m, double height)
{
  for (int i = 0; i < coefficient_count(2); ++i) {
    for (int j = 0; j <= i; ++j) a_[i][j] += m[i] * m[j];
    b_[i] += m[i] * height;
  }
}

int HeightSystem::factor(int degree)
{
  // What is left of a column when the others have explained it: with less, the places hardly tell it. An even disc
  // leaves 0.05 of x⁴ and more of the others.
  constexpr double least_share = 1e-3;
  const int n = coefficient_count(degree);
  int rank = 0;
  for (; rank < n; ++rank) {
    Coefficients& row = a_[rank];
    const double diagonal = row[rank];
    forward(row, rank);
    for (int j = 0; j < rank; ++j) {
      row[rank] -= row[j] * row[j];
      a_[j][rank] = row[j];
    }
    if (!(row[rank] > least_share * diagonal)) break;
    row[rank] = 1 / std::sqrt(row[rank]);
  }
  while (degree > 0 && coefficient_count(degree) > rank) --degree;
  return degree;
}

void HeightSystem::forward(Coefficients& x, int count) const
{
  for (int i = 0; i < count; ++i) {
    x[i] *= a_[i][i];
    for (int k = i + 1; k < count; ++k) x[k] -= a_[i][k] * x[i];
  }
}

Coefficients HeightSystem::solution(int degree) const
{
  const int n = coefficient_count(degree);
  Coefficients c = b_;
  forward(c, n);
  for (int i = n; i-- > 0;) {
    c[i] *= a_[i][i];
    for (int k = 0; k < i; ++k) c[k] -= a_[i][k] * c[i];
  }
  return c;
}

FitQuality HeightSystem::quality(const HeightPlaces& places, const std::array<const Coefficients*, 5>& parts,
                                 int degree) const
{
  const int n = coefficient_count(degree);
  Coefficients heights = b_;
  forward(heights, n);
  std::array<Coefficients, 5> whitened;
  for (std::size_t k = 0; k < parts.size(); ++k) forward(whitened[k] = *parts[k], n);
  return fit_quality(places, n, coefficient_count(degree - 1), a_, heights, whitened);
}

double HeightSystem::explained(const Coefficients& solution, int degree) const
{
  double sum = 0;
  for (int i = 0; i < coefficient_count(degree); ++i) sum += solution[i] * b_[i];
  return sum;
}

double HeightSystem::inverse_form(Coefficients b, int degree) const
{
  const int n = coefficient_count(degree);
  forward(b, n);
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += b[i] * b[i];
  return sum;
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
