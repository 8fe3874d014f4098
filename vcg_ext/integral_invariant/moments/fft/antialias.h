// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1, FFT engine: from covered fractions on a grid of half the step to samples on the grid of the transforms. A
// cell average alone lets features between the cells through as false coarse ones (aliasing), which was the largest
// error of the curvature; the filter 1 3 3 1 along each axis has a triple zero where those fall onto the lowest
// frequencies. Cost: O(cells).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace integral_invariant {

/// Fine cells along an axis that give n coarse ones: two each, and one more on either side.
inline int fine_size(int n) { return 2 * n + 2; }

/// Transfer of fine cell average and filter along one axis at the angular frequency `k` (radians a coarse cell).
double downsampling_transfer(double k);

/// `fine` of fine_size() of each entry of `size`, without padding; overwritten. `coarse` with rows along z of
/// `row_stride`, what is past a row's end becomes 0.
void downsample(std::vector<float>& fine, const std::array<int, 3>& size, float* coarse, std::size_t row_stride);

}  // namespace integral_invariant
