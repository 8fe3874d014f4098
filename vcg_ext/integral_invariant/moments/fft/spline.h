// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1, FFT engine: what lies between the grid and the continuum. Cells are averages of the solid's indicator;
// values between cell centres come from cubic B-splines. Both act per axis, so both are corrected by one factor per
// axis.
#pragma once

#include <cstddef>

#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// Cells on both sides of a position that the spline reads.
inline constexpr int spline_support = 2;

/// Factor for the angular frequency `k` (radians a cell, |k| ≤ π): undoes the cell average and prefilters for the
/// spline. Even in k, and 0 at |k| = π.
double sampling_correction(double k);

/// The 4 × 4 × 4 weights of the cubic B-spline at one position.
struct SplineWeights {
  std::size_t first;  ///< offset of the lowest of the cells read
  float x[4], y[4], z[4];
};

/// `position` in cells from the corner of the grid, at least spline_support from its faces; rows along z of
/// `row_stride`, `rows` of them along y.
SplineWeights spline_weights(const Vec3& position, std::size_t rows, std::size_t row_stride);

/// The spline's value at that position.
double spline_value(const SplineWeights& weights, const float* grid, std::size_t rows, std::size_t row_stride);

}  // namespace integral_invariant
