// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: curvature tensor of one vertex at one scale, from the moments of its ball.
#pragma once

#include "integral_invariant/moments/engine.h"
#include "integral_invariant/support/symmetric3.h"

namespace integral_invariant {

/// Symmetric tensor whose tangential eigenvalues are the principal curvatures: K n = 0.
struct CurvatureTensor {
  Symmetric3 k;           ///< 1/L; positive where the solid is convex
  Vec3 normal{0, 0, 1};   ///< unit, outward
  double confidence = 0;  ///< of the moments it came from, 0 to 1
};

/// P s P with P = I − n nᵀ.
Symmetric3 tangential_part(const Symmetric3& s, const Vec3& n);

/// The covariance J = M − m mᵀ/V of a ball's solid about its barycentre, seen from the surface.
struct TangentialCovariance {
  Symmetric3 tangential;  ///< J_T = P J P with P = I − n nᵀ
  Vec3 normal{0, 0, 1};   ///< n: the eigenvector of J best aligned with −m
  bool is_valid = false;  ///< false where all or nothing of the ball is solid
};
TangentialCovariance tangential_covariance(const BallMoments& moments, double radius);

/// K = 6/(π r⁶) (tr(J_T) I − 4 J_T) + 8/(5r) I on the tangent plane [Yang06], J the covariance of the ball's solid
/// about its barycentre and J_T its tangential part. The normal is the eigenvector of J best aligned with −m.
///
/// A ball without solid or without direction (m = 0: all or nothing of the ball is solid) has K = 0, an arbitrary
/// normal and confidence 0.
CurvatureTensor curvature_tensor(const BallMoments& moments, double radius);

/// Eigenvalues and directions of a tensor on the plane orthogonal to its normal.
struct PrincipalCurvatures {
  double kappa_max = 0, kappa_min = 0;  ///< kappa_max >= kappa_min, 1/L
  Vec3 dir_max, dir_min;                ///< unit, tangent, orthogonal; an arbitrary such pair at an umbilic
};
PrincipalCurvatures principal_curvatures(const CurvatureTensor& tensor);

/// max(|κ_max|, |κ_min|) of principal_curvatures(), without the directions.
double largest_absolute_curvature(const CurvatureTensor& tensor);

}  // namespace integral_invariant
