// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// Symmetric 3x3 matrix, upper triangle row by row.
struct Symmetric3 {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  Symmetric3& operator+=(const Symmetric3& b)
  {
    xx += b.xx;
    xy += b.xy;
    xz += b.xz;
    yy += b.yy;
    yz += b.yz;
    zz += b.zz;
    return *this;
  }
  Symmetric3& operator-=(const Symmetric3& b) { return *this += b * -1.0; }
  Symmetric3 operator*(double s) const { return {xx * s, xy * s, xz * s, yy * s, yz * s, zz * s}; }
  Vec3 operator*(const Vec3& v) const
  {
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
  }
  double trace() const { return xx + yy + zz; }
  static Symmetric3 identity(double s = 1) { return {s, 0, 0, s, 0, s}; }
};

inline Symmetric3 operator+(Symmetric3 a, const Symmetric3& b) { return a += b; }
inline Symmetric3 operator-(Symmetric3 a, const Symmetric3& b) { return a -= b; }

/// a aᵀ
inline Symmetric3 outer(const Vec3& a) { return {a.x * a.x, a.x * a.y, a.x * a.z, a.y * a.y, a.y * a.z, a.z * a.z}; }

/// a bᵀ + b aᵀ
inline Symmetric3 symmetric_outer(const Vec3& a, const Vec3& b)
{
  return {2 * a.x * b.x, a.x * b.y + b.x * a.y, a.x * b.z + b.x * a.z,
          2 * a.y * b.y, a.y * b.z + b.y * a.z, 2 * a.z * b.z};
}

/// vᵀ S v
inline double quadratic_form(const Symmetric3& s, const Vec3& v) { return dot(v, s * v); }

/// Eigenvalues in increasing order and their orthonormal eigenvectors.
struct EigenDecomposition3 {
  std::array<double, 3> values;
  std::array<Vec3, 3> vectors;
};
EigenDecomposition3 eigen_decomposition(const Symmetric3& s);

/// The unit eigenvector of `s` that is best aligned with the unit vector `guess`, signed to agree with it.
/// A few steps of Rayleigh's quotient iteration from `guess`; where they do not lead to an eigenvector within
/// 45 degrees (only such a one is certainly the best aligned), the full decomposition decides.
Vec3 eigenvector_along(const Symmetric3& s, const Vec3& guess);

}  // namespace integral_invariant
