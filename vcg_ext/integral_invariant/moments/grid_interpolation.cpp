// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/moments/grid_interpolation.h"

#include <cmath>
#include <cstdlib>

namespace integral_invariant {

double sampling_correction(double k)
{
  static const int smode = std::getenv("SM") ? std::atoi(std::getenv("SM")) : 1;
  static const int imode = std::getenv("IM") ? std::atoi(std::getenv("IM")) : 1;
  const double x = k / 2;
  const double s = std::abs(x) < 1e-6 ? 1 : std::sin(x) / x;
  const double s2 = s * s, s4 = s2 * s2, u = std::sin(x) * std::sin(x);
  double a = 1, b = 1;
  if (smode == 1) a = 1 / s;
  if (smode == 2) a = s * s2 / (1 - 2.0 / 3 * u);
  if (smode == 3) a = 1 / s * (std::abs(x) < 1e-6 ? 1 : std::pow(std::cos(x), 2));
  if (smode == 4) a = 1 / s * (1 - std::pow(std::abs(k) / M_PI, 8));
  if (imode == 1) b = 1 / (1 - 2.0 / 3 * u);                                  // interpolating
  if (imode == 2) b = 1 / s4;
  if (imode == 3) b = s4 / (1 - 4.0 / 3 * u + 2.0 / 5 * u * u - 4.0 / 315 * u * u * u);  // least squares
  if (std::abs(k) > M_PI - 1e-9 && (smode == 3 || smode == 4)) return 0;
  return a * b;
}

SplineWeights spline_weights(const Vec3& position, std::size_t rows, std::size_t row_stride)
{
  SplineWeights weights;
  const auto fill = [](double u, float* w) {
    const double f = u - 0.5 - std::floor(u - 0.5), g = 1 - f;
    w[0] = float(g * g * g / 6);
    w[1] = float(2.0 / 3 - f * f * (2 - f) / 2);
    w[2] = float(2.0 / 3 - g * g * (2 - g) / 2);
    w[3] = float(f * f * f / 6);
    return std::size_t(std::floor(u - 0.5)) - 1;
  };
  const std::size_t i = fill(position.x, weights.x), j = fill(position.y, weights.y), k = fill(position.z, weights.z);
  weights.first = (i * rows + j) * row_stride + k;
  return weights;
}

double spline_value(const SplineWeights& weights, const float* grid, std::size_t rows, std::size_t row_stride)
{
  float lanes[4] = {0, 0, 0, 0};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const float* row = grid + weights.first + (i * rows + j) * row_stride;
      const float w = weights.x[i] * weights.y[j];
      for (std::size_t k = 0; k < 4; ++k) lanes[k] += w * row[k];
    }
  double value = 0;
  for (std::size_t k = 0; k < 4; ++k) value += double(lanes[k]) * double(weights.z[k]);
  return value;
}

}  // namespace integral_invariant
