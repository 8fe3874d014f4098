// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: shrinkage. In: a curvature and its noise. Out: its posterior mean and errors. Cost: about 1 µs.
// Source: Paule and Mandel (1982); docs/method.md §10.
#include "integral_invariant/multiscale/tensor_prior.h"

#include <algorithm>
#include <array>

namespace integral_invariant {

namespace {

constexpr double least_variance = 1e-300;  // of exact values: nothing is divided by zero

/// Of the prior, from squares and variances along the axes of the noise. The sum of the squares over their variances
/// falls with p and is convex: Newton's method from below stays below.
double prior_variance(const std::array<double, 3>& square, const std::array<double, 3>& noise)
{
  constexpr double expected = 3, precision = 1e-9;
  constexpr int most_steps = 30;
  double p = 0;
  for (std::size_t k = 0; k < 3; ++k) p = std::max(p, square[k] / expected - noise[k]);
  for (int step = 0; step < most_steps; ++step) {
    double sum = 0, slope = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double inverse = 1 / (noise[k] + p + least_variance), term = square[k] * inverse;
      sum += term;
      slope += term * inverse;
    }
    if (!(sum > expected)) break;
    const double change = (sum - expected) / slope;
    p += change;
    if (change <= precision * p) break;
  }
  return p;
}

}  // namespace

PosteriorCurvature posterior_curvature(const Vec3& curvature, const Symmetric3& covariance)
{
  // Curvature that hides in the noise is taken to be as large as could have.
  constexpr double hidden_share = 0.1;
  const EigenDecomposition3 noise = eigen_decomposition(covariance);
  std::array<double, 3> along, square, variance;
  for (std::size_t k = 0; k < 3; ++k) {
    along[k] = dot(curvature, noise.vectors[k]);
    square[k] = along[k] * along[k];
    variance[k] = std::max(0.0, noise.values[k]);
  }
  const double p = prior_variance(square, variance);
  PosteriorCurvature result;
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
