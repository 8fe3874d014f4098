// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: transfer of correlated noise. In: a correlation length. Out: ratios of variances by radius.
// Cost: 50 µs once. Source: Weber's second exponential integral; docs/method.md §5.
#include "integral_invariant/multiscale/noise_transfer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "integral_invariant/support/pi.h"

namespace integral_invariant {

namespace {

constexpr double usual_area = 0.866;  // of a vertex of a regular mesh, ē²
constexpr double smallest_radius = 0.25, radius_step = 1.05;
constexpr int radius_count = 180;  // up to 1,500 ē

/// exp(−z) I_n(z) for n = 0 … 3, from the integral (1/π) ∫ exp(z (cos t − 1)) cos(n t) dt, periodic and smooth.
std::array<double, 4> scaled_bessel(double z)
{
  const int steps = 64 + int(8 * std::sqrt(z));
  std::array<double, 4> sums{};
  for (int i = 0; i < steps; ++i) {
    const double t = pi * (i + 0.5) / steps, weight = std::exp(z * (std::cos(t) - 1)) / steps;
    for (int n = 0; n < 4; ++n) sums[std::size_t(n)] += weight * std::cos(n * t);
  }
  return sums;
}

/// What an offset-free ball leaves of the mean curvature of a wave, q = k r.
double curvature_transfer(double q)
{
  constexpr double small = 0.05;
  return q < small ? 1 - q * q / 16 : 48 * ::jn(3, q) / (q * q * q);
}

/// Of noise of variance 1 on flat triangles, at wavenumber k.
double density_at(double k, double correlation)
{
  constexpr double blur = 0.42, largest = 1.2 * pi;  // measured on independent noise; the vertices' own band limit
  const double flat = std::exp(-k * k * blur * blur), l2 = correlation * correlation;
  if (correlation > 0) return 2 * pi * l2 * std::exp(-k * k * l2 / 2) * flat;
  return k < largest ? usual_area * flat : 0;
}

}  // namespace

NoiseTransfer::NoiseTransfer(double correlation) : correlation_(correlation)
{
  if (!(correlation > 0)) return;
  const double density = 2 * pi * correlation * correlation / usual_area;
  for (int i = 0; i < radius_count; ++i) {
    const double r = smallest_radius * std::pow(radius_step, i);
    const std::array<double, 4> I = scaled_bessel(r * r / (correlation * correlation));
    curvature_.push_back(density * std::max(0.0, 1 - (I[0] + 2 * I[1] + 2 * I[2] + I[3])));
    normal_.push_back(density * std::max(0.0, 1 - (I[0] + 2 * I[1] + I[2])));
  }
}

double NoiseTransfer::ratio(const std::vector<double>& table, double radius) const
{
  if (table.empty()) return 1;
  const double place = std::clamp(std::log(std::max(radius, 1e-9) / smallest_radius) / std::log(radius_step), 0.0,
                                  double(radius_count - 1) - 1e-9);
  const std::size_t i = std::size_t(place);
  return table[i] + (place - double(i)) * (table[i + 1] - table[i]);
}

double NoiseTransfer::curvature_ratio_of(double white_variance) const
{
  return curvature_.empty() ? 1 : curvature_ratio(std::pow(48 * usual_area / (pi * white_variance), 1.0 / 6));
}

double NoiseTransfer::normal_ratio_of(double white_variance) const
{
  return normal_.empty() ? 1 : normal_ratio(std::pow(4 * usual_area / (pi * white_variance), 0.25));
}

std::vector<double> difference_variances(double correlation, const std::vector<double>& radii)
{
  constexpr int steps = 300;
  constexpr double least = 0.01, largest = 6;
  const double step = std::log(largest / least) / steps;
  std::vector<double> variances(radii.size() > 1 ? radii.size() - 1 : 0, 0.0);
  for (int j = 0; j < steps; ++j) {
    const double k = least * std::exp(step * (j + 0.5)), k2 = k * k;
    const double energy = k2 * k2 / 4 * density_at(k, correlation) * k2 * step / (2 * pi);
    for (std::size_t i = 0; i < variances.size(); ++i) {
      const double passed = curvature_transfer(k * radii[i]) - curvature_transfer(k * radii[i + 1]);
      variances[i] += passed * passed * energy;
    }
  }
  return variances;
}

}  // namespace integral_invariant
