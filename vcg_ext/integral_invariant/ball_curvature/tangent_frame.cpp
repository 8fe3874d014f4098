// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: tangent frames. In: tensors, a frame. Out: their components, and back. Cost: 0.05 µs a tensor.
#include "integral_invariant/ball_curvature/tangent_frame.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

Vec3 rotate_to(const Vec3& a, const Vec3& from, const Vec3& to)
{
  const double cosine = dot(from, to);
  if (cosine < -0.99) return a;
  const Vec3 axis = cross(from, to), once = cross(axis, a);
  return a + once + cross(axis, once) * (1 / (1 + cosine));
}

TensorComponents components_of(const CurvatureTensor& t, const TangentFrame& f)
{
  const Vec3 a = rotate_to(f.u, f.normal, t.normal), b = rotate_to(f.v, f.normal, t.normal), kb = t.k * b;
  const double aa = quadratic_form(t.k, a), bb = dot(b, kb);
  return {(aa + bb) / 2, {(aa - bb) / 2, dot(a, kb)}, {dot(t.normal, f.u), dot(t.normal, f.v)}};
}

CurvatureTensor tensor_of(const TensorComponents& c, const TangentFrame& f)
{
  const double in_plane = std::min(0.99, c.tilt[0] * c.tilt[0] + c.tilt[1] * c.tilt[1]);
  const Vec3 normal = normalized(f.u * c.tilt[0] + f.v * c.tilt[1] + f.normal * std::sqrt(1 - in_plane), f.normal);
  const Vec3 u = rotate_to(f.u, f.normal, normal), v = rotate_to(f.v, f.normal, normal);
  const Symmetric3 k =
      outer(u) * (c.mean + c.deviator[0]) + outer(v) * (c.mean - c.deviator[0]) + symmetric_outer(u, v) * c.deviator[1];
  return {k, normal, 1};
}

Symmetric3 rotate_covariance(const Symmetric3& s, double x, double y)
{
  // The deviator turns twice as fast: (a c + b d, b c − a d).
  const double square = x * x + y * y;
  if (!(square > 0)) return s;
  const double c = (x * x - y * y) / square, d = 2 * x * y / square;
  return {s.xx,
          s.xy * c + s.xz * d,
          s.xz * c - s.xy * d,
          s.yy * c * c + 2 * s.yz * c * d + s.zz * d * d,
          (s.zz - s.yy) * c * d + s.yz * (c * c - d * d),
          s.yy * d * d - 2 * s.yz * c * d + s.zz * c * c};
}

}  // namespace integral_invariant
