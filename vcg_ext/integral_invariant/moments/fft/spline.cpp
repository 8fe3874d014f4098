// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/moments/fft/spline.h"

#include <cmath>

#include "integral_invariant/moments/fft/antialias.h"
#include "integral_invariant/support/pi.h"

namespace integral_invariant {

double sampling_correction(double k)
{
  // The prefilter that makes the spline interpolate: the inverse of (1 4 1)/6. Measured against the least squares
  // prefilter and the one that is exact for the lowest frequencies, it gave the smallest error of the curvature.
  const double s = std::sin(k / 2), prefilter = 1 / (1 - 2.0 / 3 * s * s);
  // Near |k| = π the samples are as much alias as signal: let the band end smoothly there, with a double zero, so that
  // the kernels ring little beyond the ball. Lower powers cost accuracy at edges, higher ones on smooth surfaces.
  const double end = 1 - std::pow(k / pi, 6), taper = end * end;
  return taper * prefilter / downsampling_transfer(k);
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
