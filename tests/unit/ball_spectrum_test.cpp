// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/moments/fft/ball_spectrum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "integral_invariant/moments/fft/spline.h"
#include "integral_invariant/vec3.h"

using namespace integral_invariant;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr std::array<int, 3> size{16, 12, 20};
constexpr double radius = 2.7;

std::array<double, moment_count> polynomials(const Vec3& y)
{
  return {1, y.x, y.y, y.z, y.x * y.x, y.x * y.y, y.x * y.z, y.y * y.y, y.y * y.z, y.z * y.z};
}

/// ∫ f(y) exp(i k·y) dy over the ball, by the midpoint rule in radius and height and in the angle around z.
std::array<std::complex<double>, moment_count> integrals_over_ball(const Vec3& k)
{
  constexpr int radii = 120, heights = 160, angles = 40;
  std::array<std::complex<double>, moment_count> sums{};
  for (int a = 0; a < radii; ++a)
    for (int b = 0; b < heights; ++b)
      for (int c = 0; c < angles; ++c) {
        const double r = radius * (a + 0.5) / radii, u = -1 + 2 * (b + 0.5) / heights, phi = 2 * pi * c / angles;
        const double s = r * std::sqrt(1 - u * u);
        const Vec3 y{s * std::cos(phi), s * std::sin(phi), r * u};
        const auto wave = std::polar(r * r * (radius / radii) * (2.0 / heights) * (2 * pi / angles), dot(k, y));
        const auto f = polynomials(y);
        for (std::size_t m = 0; m < f.size(); ++m) sums[m] += f[m] * wave;
      }
  return sums;
}

double frequency(int i, int n) { return 2 * pi * (2 * i <= n ? i : i - n) / n; }

TEST(BallSpectrum, SeriesAndClosedFormMeet)
{
  const auto below = radial_spectra(2 - 1e-9), above = radial_spectra(2 + 1e-9);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(below[i], above[i], 1e-8 * std::abs(above[i]));
}

TEST(BallSpectrum, AtZeroHoldsTheMomentsOfTheUnitBall)
{
  const auto spectrum = radial_spectra(0);
  EXPECT_NEAR(spectrum[0], 4 * pi / 3, 1e-15);
  EXPECT_NEAR(spectrum[1], 4 * pi / 15, 1e-15);
  EXPECT_NEAR(spectrum[2], 4 * pi / 105, 1e-15);
}

TEST(BallSpectrum, AllTenAgreeWithNumericalIntegration)
{
  const std::size_t half = std::size_t(size[2]) / 2 + 1, count = std::size_t(size[0]) * std::size_t(size[1]) * half;
  const std::vector<std::complex<float>> ones(count, 1.0f);
  const BallSpectrum kernel(size, radius);
  const std::array<std::array<int, 3>, 5> places{{{0, 0, 0}, {1, 0, 0}, {2, 11, 3}, {13, 4, 1}, {15, 10, 6}}};
  for (const auto& at : places) {
    const Vec3 k{frequency(at[0], size[0]), frequency(at[1], size[1]), frequency(at[2], size[2])};
    const auto expected = integrals_over_ball(k);
    const double factor = sampling_correction(k.x) * sampling_correction(k.y) * sampling_correction(k.z) /
                          (double(size[0]) * size[1] * size[2]);
    const std::size_t index =
        (std::size_t(at[0]) * std::size_t(size[1]) + std::size_t(at[1])) * half + std::size_t(at[2]);
    for (int m = 0; m < moment_count; ++m) {
      std::vector<std::complex<float>> result(count);
      kernel.apply(m, ones.data(), result.data());
      const std::complex<double> found(result[index]);
      const double scale = 4 * pi / 3 * std::pow(radius, m == 0 ? 3 : m < 4 ? 4 : 5);
      EXPECT_LT(std::abs(found / factor - expected[std::size_t(m)]) / scale, 1e-4) << "moment " << m << " at " << at[0];
    }
  }
}

TEST(SamplingCorrection, EndsAtTheNyquistFrequencyAndKeepsTheMean)
{
  EXPECT_DOUBLE_EQ(sampling_correction(0), 1);
  EXPECT_NEAR(sampling_correction(pi), 0, 1e-12);
  EXPECT_DOUBLE_EQ(sampling_correction(-1.1), sampling_correction(1.1));
}

}  // namespace
