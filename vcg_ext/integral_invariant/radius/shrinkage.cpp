// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: shrinkage. In: a curvature and its noise. Out: its posterior mean and errors. Cost: about 1 µs.
// Source: Paule and Mandel (1982); docs/accuracy.md.
#include "integral_invariant/radius/shrinkage.h"

#include <algorithm>
#include <array>

namespace integral_invariant {

namespace {

constexpr double least_variance = 1e-300;  // of exact values: nothing is divided by zero

/// Of the prior, from squares and variances along the axes of the noise: the sum falls with p, so halving finds it.
double prior_variance(const std::array<double, 3>& square, const std::array<double, 3>& noise)
{
  constexpr double expected = 3;
  constexpr int halvings = 50;
  double low = 0, high = (square[0] + square[1] + square[2]) / expected;
  for (int i = 0; i < halvings; ++i) {
    const double p = (low + high) / 2;
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += square[k] / (noise[k] + p + least_variance);
    (sum > expected ? low : high) = p;
  }
  return low;
}

}  // namespace

ShrunkCurvature shrunk_to_plane(const Vec3& curvature, const Symmetric3& covariance)
{
  // Curvature that hides in the noise is taken to be as large as could have.
  constexpr double hidden_share = 0.1;
  const Eigen3 noise = eigen_decomposition(covariance);
  std::array<double, 3> along, square, variance;
  for (std::size_t k = 0; k < 3; ++k) {
    along[k] = dot(curvature, noise.vectors[k]);
    square[k] = along[k] * along[k];
    variance[k] = std::max(0.0, noise.values[k]);
  }
  const double p = prior_variance(square, variance);
  ShrunkCurvature result;
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = p / (p + variance[k] + least_variance), lost = 1 - weight;
    const Vec3& axis = noise.vectors[k];
    result.value += axis * (weight * along[k]);
    const double error = weight * weight * variance[k] + lost * lost * std::max(p, hidden_share * variance[k]);
    result.variance += Vec3{axis.x * axis.x, axis.y * axis.y, axis.z * axis.z} * error;
  }
  return result;
}

}  // namespace integral_invariant
