// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: curvature tensor of one vertex at one scale. In: ball moments (normalised units). Out: tensor and normal.
// Cost: O(1), about 0.1 µs. Source: [Yang06], with the normal chosen as docs/published.md says.
#include "integral_invariant/ball_curvature/curvature_tensor.h"

#include <algorithm>

#include "integral_invariant/support/pi.h"

namespace integral_invariant {

namespace {

/// The tensor's 2x2 matrix in the tangent basis (u, v).
struct Tangential2 {
  double uu, uv, vv;

  double mean() const { return (uu + vv) / 2; }
  /// Half of κ_max − κ_min.
  double half_difference() const { return std::hypot((uu - vv) / 2, uv); }
};

Tangential2 in_basis(const Symmetric3& k, const Vec3& u, const Vec3& v)
{
  const Vec3 kv = k * v;
  return {quadratic_form(k, u), dot(u, kv), dot(v, kv)};
}

}  // namespace

Symmetric3 tangential_part(const Symmetric3& s, const Vec3& n)
{
  const Vec3 sn = s * n;
  return s - symmetric_outer(sn, n) + outer(n) * dot(n, sn);
}

TangentialCovariance tangential_covariance(const BallMoments& moments, double radius)
{
  const double away = norm(moments.first);
  // Under rounding, a ball that is all solid or all empty has no direction.
  constexpr double no_direction = 1e-12, no_volume = 1e-12;
  const bool has_solid = moments.volume > no_volume * radius * radius * radius;
  if (!has_solid || !(away > no_direction * radius * moments.volume)) return {};

  const Symmetric3 covariance = moments.second - outer(moments.first) * (1 / moments.volume);
  const Vec3 normal = eigenvector_along(covariance, moments.first * (-1 / away));
  return {tangential_part(covariance, normal), normal, true};
}

CurvatureTensor curvature_tensor(const BallMoments& moments, double radius)
{
  const TangentialCovariance covariance = tangential_covariance(moments, radius);
  if (!covariance.is_valid) return {};
  const Symmetric3& tangential = covariance.tangential;
  const double r6 = radius * radius * radius * radius * radius * radius;
  const double factor = 6 / (pi * r6);
  const double isotropic = factor * tangential.trace() + 8 / (5 * radius);
  const Symmetric3 projector = Symmetric3::identity() - outer(covariance.normal);
  return {projector * isotropic - tangential * (4 * factor), covariance.normal, moments.confidence};
}

PrincipalCurvatures principal_curvatures(const CurvatureTensor& tensor)
{
  const Vec3 u = any_orthogonal(tensor.normal), v = cross(tensor.normal, u);
  const Tangential2 k = in_basis(tensor.k, u, v);
  const double half_difference = k.half_difference();
  // Angle of κ_max's direction from u; atan2(0, 0) = 0 picks the basis itself at an umbilic.
  const double angle = std::atan2(k.uv, (k.uu - k.vv) / 2) / 2;
  const Vec3 dir_max = normalized(u * std::cos(angle) + v * std::sin(angle), u);
  return {k.mean() + half_difference, k.mean() - half_difference, dir_max, cross(tensor.normal, dir_max)};
}

double largest_absolute_curvature(const CurvatureTensor& tensor)
{
  // Invariants of P K P, P = I − n nᵀ: its trace, and its squared norm κ₁² + κ₂².
  const Symmetric3& k = tensor.k;
  const Vec3 kn = k * tensor.normal;
  const double nkn = dot(tensor.normal, kn);
  const double mean = (k.trace() - nkn) / 2;
  const double squares = k.xx * k.xx + k.yy * k.yy + k.zz * k.zz + 2 * (k.xy * k.xy + k.xz * k.xz + k.yz * k.yz) -
                         2 * squared_norm(kn) + nkn * nkn;
  return std::abs(mean) + std::sqrt(std::max(0.0, squares / 2 - mean * mean));
}

}  // namespace integral_invariant
