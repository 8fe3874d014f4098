// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: least squares fit of a height over a tangent plane by a polynomial, and the curvature of the graph.
#pragma once

#include "integral_invariant/ball_curvature/curvature_tensor.h"
#include "integral_invariant/jets/least_squares_kernels.h"

namespace integral_invariant {

/// Least squares polynomial.
class HeightFit {
 public:
  /// Of the largest degree, up to the one given, that the places determine.
  HeightFit(const HeightSums& sums, int degree);

  /// 0 where the places leave even a plane open; then there is nothing else.
  int degree() const { return degree_; }
  Coefficients coefficients() const;
  /// Σ w off², from the sums: to about 1e-15 of Σ w h².
  double squares() const;
  /// Variance of a part under independent noise of variance 1. \pre all places weigh 1
  double variance(HeightPart part) const { return covariance(part, part); }
  double covariance(HeightPart a, HeightPart b) const;
  /// The same for places of any weights, and more. \param places those that the sums are of
  FitQuality quality(const HeightPlaces& places) const;

 private:
  double column_product(std::size_t a, std::size_t b) const;

  int degree_;
  double sum_of_squares_;
  HeightMatrix factor_;
  WhitenedColumns whitened_;
};

/// Orthonormal frame in which heights are measured along `normal`.
struct HeightFrame {
  explicit HeightFrame(const Vec3& up);
  Vec3 normal, x, y;
};

/// Curvature tensor and normal of the graph over the frame's origin; `unit` is the length that x and y were divided by.
CurvatureTensor graph_curvature(const Coefficients& heights, const HeightFrame& frame, double unit);

}  // namespace integral_invariant
