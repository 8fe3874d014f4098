// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: curvature tensors at any radius between the scales, by a partition of unity [Lai09 4.1].
#pragma once

#include <cstddef>
#include <vector>

#include "integral_invariant/ball_curvature/curvature_tensor.h"
#include "integral_invariant/support/zeroed_array.h"

namespace integral_invariant {

/// Curvature tensors of all vertices at all scales, in single precision (10 floats each): rounding at 6e-8 of the
/// largest entry is far under the error of any estimator, and half the memory.
class TensorField {
 public:
  /// All tensors zero, with confidence 0, until set.
  TensorField(std::size_t vertices, std::vector<double> radii);

  std::size_t vertex_count() const { return vertices_; }
  /// Increasing, normalised unit.
  const std::vector<double>& radii() const { return radii_; }

  /// Calls for different (vertex, scale) may run at once.
  void set(std::size_t vertex, int scale, const CurvatureTensor& tensor);
  CurvatureTensor at_scale(std::size_t vertex, int scale) const;

  /// The tensor at radius r: Σ w_i K_i with w_i = h_i / Σ h, h_i = exp(−(r − r_i)²/σ_i²), σ_i half the local gap.
  /// What is blended are curvature tensors, not covariances: those grow like r⁵, and a blend of them would read as
  /// curvature on a plane. A tensor that is the same at all scales is reproduced at every r.
  /// `r` is clamped to the range of the radii.
  CurvatureTensor at_radius(std::size_t vertex, double r) const;

  static std::size_t bytes_per_vertex(std::size_t scales);

 private:
  struct Entry {
    float k[6];
    float normal[3];
    float confidence;
  };
  struct Weights {
    int first, count;
    double value[5];
  };
  Weights weights_at(double r) const;

  std::size_t vertices_;
  std::vector<double> radii_, inverse_sigma_;
  ZeroedArray<Entry> entries_;
};

}  // namespace integral_invariant
