// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: polynomial moments of a set of triangles that can be moved to any centre without loss.
#include "integral_invariant/moments/surface/surface_multipoles.h"

namespace integral_invariant {

namespace {

double component(const Vec3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

/// ∫ n·u
double radial_volume(const SurfaceMultipoles& m) { return m.first[0].x + m.first[1].y + m.first[2].z; }

/// ∫ (n·u) u
Vec3 radial_first(const SurfaceMultipoles& m)
{
  return {m.second[0].xx + m.second[1].xy + m.second[2].xz, m.second[0].xy + m.second[1].yy + m.second[2].yz,
          m.second[0].xz + m.second[1].yz + m.second[2].zz};
}

}  // namespace

SurfaceMultipoles triangle_multipoles(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 sum = a + b + c;
  const Symmetric3 square = (outer(a) + outer(b) + outer(c) + outer(sum)) * (1.0 / 12);
  SurfaceMultipoles m;
  m.normal = cross(b - a, c - a) * 0.5;
  for (int k = 0; k < 3; ++k) {
    m.first[k] = sum * (component(m.normal, k) / 3);
    m.second[k] = square * component(m.normal, k);
  }
  m.third = square * dot(m.normal, a);
  return m;
}

SurfaceMultipoles translated(const SurfaceMultipoles& m, const Vec3& shift)
{
  SurfaceMultipoles t = m;
  for (int k = 0; k < 3; ++k) {
    const double n_k = component(m.normal, k);
    t.first[k] += shift * n_k;
    t.second[k] += symmetric_outer(shift, m.first[k]) + outer(shift) * n_k;
  }
  t.third += symmetric_outer(shift, radial_first(m)) + outer(shift) * radial_volume(m);
  for (int k = 0; k < 3; ++k) t.third += t.second[k] * component(shift, k);
  return t;
}

SolidMoments cone_moments(const SurfaceMultipoles& moments, const Vec3& shift)
{
  const SurfaceMultipoles m = translated(moments, shift);
  return {radial_volume(m) / 3, radial_first(m) * 0.25, m.third * 0.2};
}

}  // namespace integral_invariant
