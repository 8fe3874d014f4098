// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1, FFT engine: real three-dimensional transforms in place, single precision. The only file that knows FFTW.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <memory>

namespace integral_invariant {

/// Memory of one transform, aligned for SIMD: as reals, rows along z of `row_stride()` floats (two or one more than the
/// transform's size); as complex, rows of size[2]/2 + 1.
class FftBuffer {
 public:
  explicit FftBuffer(const std::array<int, 3>& size);

  float* reals() { return data_.get(); }
  const float* reals() const { return data_.get(); }
  std::complex<float>* complexes() { return reinterpret_cast<std::complex<float>*>(data_.get()); }
  const std::complex<float>* complexes() const { return reinterpret_cast<const std::complex<float>*>(data_.get()); }

  static std::size_t row_stride(const std::array<int, 3>& size) { return 2 * (std::size_t(size[2]) / 2 + 1); }
  static std::size_t bytes(const std::array<int, 3>& size);

 private:
  struct Free {
    void operator()(float* data) const;
  };
  std::unique_ptr<float, Free> data_;
};

/// Forward and inverse transforms of one size, neither normalised. Several threads may use one object at once, each
/// with its own buffer. The same input gives the same output to the last bit, whichever thread runs it and whenever:
/// plans are estimated, not measured, because a plan that depends on timings rounds differently from run to run.
class RealTransform {
 public:
  explicit RealTransform(const std::array<int, 3>& size);

  void forward(FftBuffer& buffer) const;
  void inverse(FftBuffer& buffer) const;

 private:
  struct Destroy {
    void operator()(void* plan) const;
  };
  std::unique_ptr<void, Destroy> forward_, inverse_;
};

}  // namespace integral_invariant
