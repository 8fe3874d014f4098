// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: curvature tensors of one vertex in one frame, so that they can be compared.
#pragma once

#include <array>

#include "integral_invariant/ball_curvature/curvature_tensor.h"

namespace integral_invariant {

/// `a` turned as the shortest rotation turns the unit vector `from` to `to`; `a` itself where they are opposite.
Vec3 rotate_to(const Vec3& a, const Vec3& from, const Vec3& to);

/// Orthonormal, right-handed.
struct TangentFrame {
  Vec3 normal, u, v;
};

/// A tensor as a frame sees it that is turned to the tensor's own tangent plane.
struct TensorComponents {
  double mean = 0;                   ///< H
  std::array<double, 2> deviator{};  ///< (K_uu − K_vv)/2, K_uv
  std::array<double, 2> tilt{};      ///< of its normal, along u and v
};
TensorComponents components_of(const CurvatureTensor& tensor, const TangentFrame& frame);

/// The tensor of these components, with confidence 1; its inverse.
CurvatureTensor tensor_of(const TensorComponents& components, const TangentFrame& frame);

/// Covariance of (H, (K_uu − K_vv)/2, K_uv) in the frame whose u is along (x, y) in the frame in which it is
/// `covariance`.
Symmetric3 rotate_covariance(const Symmetric3& covariance, double x, double y);

}  // namespace integral_invariant
