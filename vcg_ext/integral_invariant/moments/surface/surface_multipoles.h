// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: polynomial moments of a set of triangles that can be moved to any centre without loss.
#pragma once

#include "integral_invariant/moments/solid_moments.h"

namespace integral_invariant {

/// ∫n, ∫u n_k, ∫u uᵀ n_k, ∫(n·u) u uᵀ over triangles with area element n dA; u from a centre. These 36 numbers give the
/// moments of the cones from any point to the triangles exactly: they are what lets distant triangles be summed once.
struct SurfaceMultipoles {
  Vec3 normal;           ///< ∫ n
  Vec3 first[3];         ///< first[k] = ∫ u n_k
  Symmetric3 second[3];  ///< second[k] = ∫ u uᵀ n_k
  Symmetric3 third;      ///< ∫ (n·u) u uᵀ

  SurfaceMultipoles& operator+=(const SurfaceMultipoles& b)
  {
    normal += b.normal;
    for (int k = 0; k < 3; ++k) {
      first[k] += b.first[k];
      second[k] += b.second[k];
    }
    third += b.third;
    return *this;
  }
};

/// Of the triangle with these vertices, u from the origin.
SurfaceMultipoles triangle_multipoles(const Vec3& a, const Vec3& b, const Vec3& c);

/// The same triangles with u from another centre; `shift` leads from the new centre to the old one.
SurfaceMultipoles translated(const SurfaceMultipoles& moments, const Vec3& shift);

/// ∫ of 1, y, y yᵀ over the cones from `apex` to the triangles, y from the apex; `shift` leads from the apex to the
/// centre.
SolidMoments cone_moments(const SurfaceMultipoles& moments, const Vec3& shift);

}  // namespace integral_invariant
