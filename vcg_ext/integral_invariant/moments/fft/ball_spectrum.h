// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1, FFT engine: the ten functions 1, y_i, y_i y_j on the ball, in the frequency domain. In: a radius in cells
// and the size of the transform. Out: factors by which the transform of the cells is multiplied. Source: [Pottmann07],
// [Lai09 4.1]; the ball's transform in closed form (docs/fft_engine.md).
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

namespace integral_invariant {

/// The ten moments in the order V, m_x, m_y, m_z, M_xx, M_xy, M_xz, M_yy, M_yz, M_zz.
inline constexpr int moment_count = 10;

/// 4π j₁(q)/q, 4π j₂(q)/q², 4π j₃(q)/q³ with the spherical Bessel functions j: with q = k r, b(k) = r³·(first) is the
/// transform of the ball's indicator, ∇b = −r⁵ k·(second), ∇∇b = −r⁵ I·(second) + r⁷ k kᵀ·(third).
std::array<double, 3> radial_spectra(double q);

/// The kernels of one radius for one size of transform. They correct, per axis, for what sampling by cell averages and
/// reconstruction by cubic B-splines take away (spline.h), and for the transforms' missing 1/N.
class BallSpectrum {
 public:
  /// `radius` in cells. Cost: the radial functions at 1/8 of the frequencies, by symmetry.
  BallSpectrum(const std::array<int, 3>& size, double radius);

  /// result = transform · conj(kernel of `moment`): a correlation, hence the moment about every cell centre, in cells.
  void apply(int moment, const std::complex<float>* transform, std::complex<float>* result) const;

  static std::size_t bytes(const std::array<int, 3>& size);

 private:
  struct Radial {
    float ball, first, second;
  };
  struct Axis {
    std::vector<float> k;   ///< angular frequency; 0 at the Nyquist frequency, where an odd kernel has no real value
    std::vector<int> fold;  ///< index of |k|
  };
  const Radial* row(int i, int j) const;
  template <class Factor>
  void multiply(const Factor& factor, const std::complex<float>* transform, std::complex<float>* result) const;

  std::array<int, 3> size_, half_;
  std::array<Axis, 3> axes_;
  std::vector<Radial> radial_;
};

}  // namespace integral_invariant
