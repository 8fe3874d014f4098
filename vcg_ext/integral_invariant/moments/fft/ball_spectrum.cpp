// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/moments/fft/ball_spectrum.h"

#include <cmath>

#include "integral_invariant/moments/fft/spline.h"
#include "integral_invariant/support/pi.h"

namespace integral_invariant {

namespace {

/// 4π j_n(q)/qⁿ by its power series 4π/(2n+1)!! · Σ (−q²/2)^i / (i! (2n+3)(2n+5)…(2n+2i+1)).
double series(int n, double leading, double q)
{
  double term = 4 * pi * leading, sum = term;
  for (int i = 1; i < 14; ++i) {
    term *= -0.5 * q * q / (i * (2 * n + 2 * i + 1));
    sum += term;
  }
  return sum;
}

/// Angular frequency of index i of an axis with n samples.
double frequency(int i, int n) { return 2 * pi * (2 * i <= n ? i : i - n) / n; }

}  // namespace

std::array<double, 3> radial_spectra(double q)
{
  // Below 2 the closed forms lose up to q⁻⁶ to cancellation; there fourteen terms of the series are exact to 1e-16.
  if (q < 2) return {series(1, 1.0 / 3, q), series(2, 1.0 / 15, q), series(3, 1.0 / 105, q)};
  const double s = std::sin(q), c = std::cos(q), j0 = s / q, j1 = (j0 - c) / q;
  const double j2 = 3 * j1 / q - j0, j3 = 5 * j2 / q - j1;
  return {4 * pi * j1 / q, 4 * pi * j2 / (q * q), 4 * pi * j3 / (q * q * q)};
}

BallSpectrum::BallSpectrum(const std::array<int, 3>& size, double radius) : size_(size)
{
  std::array<std::vector<double>, 3> correction;
  double samples = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    half_[a] = size[a] / 2 + 1;
    samples *= size[a];
    for (int i = 0; i < size[a]; ++i) {
      axes_[a].k.push_back(2 * i == size[a] ? 0.0f : float(frequency(i, size[a])));
      axes_[a].fold.push_back(2 * i <= size[a] ? i : size[a] - i);
    }
    for (int i = 0; i < half_[a]; ++i) correction[a].push_back(sampling_correction(frequency(i, size[a])));
  }
  const double r3 = radius * radius * radius, r5 = r3 * radius * radius, r7 = r5 * radius * radius;
  radial_.reserve(std::size_t(half_[0]) * std::size_t(half_[1]) * std::size_t(half_[2]));
  for (int i = 0; i < half_[0]; ++i)
    for (int j = 0; j < half_[1]; ++j)
      for (int l = 0; l < half_[2]; ++l) {
        const double kx = frequency(i, size[0]), ky = frequency(j, size[1]), kz = frequency(l, size[2]);
        const auto [ball, first, second] = radial_spectra(radius * std::sqrt(kx * kx + ky * ky + kz * kz));
        const double weight =
            correction[0][std::size_t(i)] * correction[1][std::size_t(j)] * correction[2][std::size_t(l)] / samples;
        radial_.push_back({float(r3 * ball * weight), float(r5 * first * weight), float(r7 * second * weight)});
      }
}

std::size_t BallSpectrum::bytes(const std::array<int, 3>& size)
{
  std::size_t count = sizeof(Radial);
  for (const int n : size) count *= std::size_t(n) / 2 + 1;
  return count;
}

const BallSpectrum::Radial* BallSpectrum::row(int i, int j) const
{
  const int fold_i = axes_[0].fold[std::size_t(i)], fold_j = axes_[1].fold[std::size_t(j)];
  return radial_.data() + (std::size_t(fold_i) * std::size_t(half_[1]) + std::size_t(fold_j)) * std::size_t(half_[2]);
}

template <class Factor>
void BallSpectrum::multiply(const Factor& factor, const std::complex<float>* transform,
                            std::complex<float>* result) const
{
  const std::size_t length = std::size_t(half_[2]);
  const float* kz = axes_[2].k.data();
  for (int i = 0; i < size_[0]; ++i)
    for (int j = 0; j < size_[1]; ++j) {
      const Radial* radial = row(i, j);
      const float kx = axes_[0].k[std::size_t(i)], ky = axes_[1].k[std::size_t(j)];
      for (std::size_t l = 0; l < length; ++l) result[l] = factor(radial[l], kx, ky, kz[l], transform[l]);
      transform += length;
      result += length;
    }
}

void BallSpectrum::apply(int moment, const std::complex<float>* transform, std::complex<float>* result) const
{
  using Value = std::complex<float>;
  const auto times_i = [](float f, const Value& v) { return Value(-f * v.imag(), f * v.real()); };
  const auto run = [&](const auto& factor) { multiply(factor, transform, result); };
  switch (moment) {
    case 0:
      return run([](const Radial& b, float, float, float, const Value& v) { return b.ball * v; });
    case 1:
      return run([&](const Radial& b, float x, float, float, const Value& v) { return times_i(b.first * x, v); });
    case 2:
      return run([&](const Radial& b, float, float y, float, const Value& v) { return times_i(b.first * y, v); });
    case 3:
      return run([&](const Radial& b, float, float, float z, const Value& v) { return times_i(b.first * z, v); });
    case 4:
      return run(
          [](const Radial& b, float x, float, float, const Value& v) { return (b.first - b.second * x * x) * v; });
    case 5:
      return run([](const Radial& b, float x, float y, float, const Value& v) { return (-b.second * x * y) * v; });
    case 6:
      return run([](const Radial& b, float x, float, float z, const Value& v) { return (-b.second * x * z) * v; });
    case 7:
      return run(
          [](const Radial& b, float, float y, float, const Value& v) { return (b.first - b.second * y * y) * v; });
    case 8:
      return run([](const Radial& b, float, float y, float z, const Value& v) { return (-b.second * y * z) * v; });
    default:
      return run(
          [](const Radial& b, float, float, float z, const Value& v) { return (b.first - b.second * z * z) * v; });
  }
}

}  // namespace integral_invariant
