// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/moments/fft/fftw_plan.h"

#include <fftw3.h>

#include <mutex>
#include <new>

namespace integral_invariant {

namespace {

/// FFTW's planner keeps global state: one thread at a time.
std::mutex& planner_mutex()
{
  static std::mutex mutex;
  return mutex;
}

fftwf_plan as_plan(void* plan) { return static_cast<fftwf_plan>(plan); }
fftwf_complex* as_fftw(FftBuffer& buffer) { return reinterpret_cast<fftwf_complex*>(buffer.reals()); }

}  // namespace

std::size_t FftBuffer::bytes(const std::array<int, 3>& size)
{
  return std::size_t(size[0]) * std::size_t(size[1]) * row_stride(size) * sizeof(float);
}

FftBuffer::FftBuffer(const std::array<int, 3>& size) : data_(fftwf_alloc_real(bytes(size) / sizeof(float)))
{
  if (!data_) throw std::bad_alloc();
}

void FftBuffer::Free::operator()(float* data) const { fftwf_free(data); }

RealTransform::RealTransform(const std::array<int, 3>& size)
{
  FftBuffer buffer(size);  // for its alignment only: an estimated plan does not touch the data
  const std::lock_guard lock(planner_mutex());
  forward_.reset(fftwf_plan_dft_r2c_3d(size[0], size[1], size[2], buffer.reals(), as_fftw(buffer), FFTW_ESTIMATE));
  inverse_.reset(fftwf_plan_dft_c2r_3d(size[0], size[1], size[2], as_fftw(buffer), buffer.reals(), FFTW_ESTIMATE));
  if (!forward_ || !inverse_) throw std::bad_alloc();
}

void RealTransform::Destroy::operator()(void* plan) const
{
  const std::lock_guard lock(planner_mutex());
  fftwf_destroy_plan(as_plan(plan));
}

void RealTransform::forward(FftBuffer& buffer) const
{
  fftwf_execute_dft_r2c(as_plan(forward_.get()), buffer.reals(), as_fftw(buffer));
}

void RealTransform::inverse(FftBuffer& buffer) const
{
  fftwf_execute_dft_c2r(as_plan(inverse_.get()), as_fftw(buffer), buffer.reals());
}

}  // namespace integral_invariant
