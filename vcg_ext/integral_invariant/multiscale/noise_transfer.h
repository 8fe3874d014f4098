// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: what balls leave of noise that is correlated from vertex to vertex.
#pragma once

#include <vector>

namespace integral_invariant {

/// Noise of variance σ² whose correlation falls like exp(−d²/2ℓ²) with the distance d has, at wavenumber k, the density
/// 2πℓ² σ² exp(−k²ℓ²/2) where independent noise has σ² times the area a vertex. An offset-free ball of radius r is, to
/// first order, the least squares paraboloid on its disc: of a wave it leaves 48 J₃(kr)/(kr)³ of the curvature and
/// 8 J₂(kr)/(kr)² of the slope. So its variance is that under independent noise times a ratio that depends on r/ℓ
/// alone.
class NoiseTransfer {
 public:
  /// \param correlation ℓ in average edge lengths; 0: independent noise, whose ratios are 1
  explicit NoiseTransfer(double correlation = 0);

  double correlation() const { return correlation_; }
  /// Variance of the curvature (of the normal) that a ball of radius r reads, over that under independent noise.
  double curvature_ratio(double radius) const { return ratio(curvature_, radius); }
  double normal_ratio(double radius) const { return ratio(normal_, radius); }
  /// The same for any other estimate, which passes noise like the ball that has its variance under independent noise of
  /// variance 1.
  double curvature_ratio_of(double white_variance) const;
  double normal_ratio_of(double white_variance) const;

 private:
  double ratio(const std::vector<double>& table, double radius) const;

  double correlation_;
  std::vector<double> curvature_, normal_;  ///< by the logarithm of the radius
};

/// Variance of H(r_i) − H(r_{i+1}) for each pair of neighbouring radii (increasing, ē), under noise of variance 1; as
/// balls over flat triangles see it, which damps waves of few edges.
std::vector<double> difference_variances(double correlation, const std::vector<double>& radii);

}  // namespace integral_invariant
