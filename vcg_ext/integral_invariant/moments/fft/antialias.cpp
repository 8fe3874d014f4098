// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/moments/fft/antialias.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

namespace {

/// Row i of the result is the filter over the rows 2i … 2i+3, of `length` each; in place, since i ≤ 2i.
void filter_rows(float* rows, std::size_t count, std::size_t length)
{
  for (std::size_t i = 0; i < count; ++i) {
    const float* from = rows + 2 * i * length;
    float* to = rows + i * length;
    for (std::size_t l = 0; l < length; ++l)
      to[l] = 0.125f * (from[l] + from[l + 3 * length]) + 0.375f * (from[l + length] + from[l + 2 * length]);
  }
}

}  // namespace

double downsampling_transfer(double k)
{
  const double x = k / 4, sinc = std::abs(x) < 1e-6 ? 1 : std::sin(x) / x;
  return sinc * std::cos(x) * std::cos(x) * std::cos(x);
}

void downsample(std::vector<float>& fine, const std::array<int, 3>& size, float* coarse, std::size_t row_stride)
{
  const std::size_t nx = std::size_t(size[0]), ny = std::size_t(size[1]), nz = std::size_t(size[2]);
  const std::size_t fine_y = std::size_t(fine_size(size[1])), fine_z = std::size_t(fine_size(size[2]));
  const std::size_t plane = fine_y * fine_z;
  filter_rows(fine.data(), nx, plane);
  for (std::size_t i = 0; i < nx; ++i) {
    filter_rows(fine.data() + i * plane, ny, fine_z);
    for (std::size_t j = 0; j < ny; ++j) {
      const float* from = fine.data() + i * plane + j * fine_z;
      float* to = coarse + (i * ny + j) * row_stride;
      for (std::size_t k = 0; k < nz; ++k, from += 2)
        to[k] = 0.125f * (from[0] + from[3]) + 0.375f * (from[1] + from[2]);
      std::fill(to + nz, to + row_stride, 0.0f);
    }
  }
}

}  // namespace integral_invariant
