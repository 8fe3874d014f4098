// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: sums of fluxes over the points that stand for distant surface.
#include "integral_invariant/moments/surface/kernels/multipole.h"

#include <cmath>

#include "integral_invariant/support/simd.h"

namespace integral_invariant {

namespace {

constexpr std::size_t lanes = kernel_lanes;
using LaneSums = FluxSums::Lanes;

/// The ten moments of degree 0, 1, 2 in lane j, to the sums from `first` on.
[[gnu::always_inline]] inline void add_moments(LaneSums& sum, std::size_t first, std::size_t j, double m, double mx,
                                               double my, double mz, double mxx, double mxy, double mxz, double myy,
                                               double myz, double mzz)
{
  const double moments[10] = {m, mx, my, mz, mxx, mxy, mxz, myy, myz, mzz};
  for (std::size_t i = 0; i < 10; ++i) sum.value[first + i][j] += moments[i];
}

/// Bounded at 0, where points that do not count may stand.
inline double bounded(double squared_distance) { return squared_distance > 1e-6 ? squared_distance : 1e-6; }

/// A lane's triangle as the balls' centre sees it: x, |x|², h = weight · x·∫n.
struct SeenPoint {
  double x, y, z, r2, h;
};

[[gnu::always_inline]] inline SeenPoint seen_from(const Vec3& centre, const TrianglePacket& group,
                                                  const LaneWeights& weights, std::size_t j)
{
  const double x = group.point[0][j] - centre.x, y = group.point[1][j] - centre.y, z = group.point[2][j] - centre.z;
  return {x, y, z, x * x + y * y + z * z,
          (x * group.area[0][j] + y * group.area[1][j] + z * group.area[2][j]) * weights.weight[j]};
}

/// S x for a lane's second moments S.
[[gnu::always_inline]] inline Vec3 second_times(const TrianglePacket& group, std::size_t j, const SeenPoint& p)
{
  const auto& s = group.second;
  return {s[0][j] * p.x + s[1][j] * p.y + s[2][j] * p.z, s[1][j] * p.x + s[3][j] * p.y + s[4][j] * p.z,
          s[2][j] * p.x + s[4][j] * p.y + s[5][j] * p.z};
}

[[gnu::always_inline]] inline bool holds(const FluxSums::Shell& shell, double r2)
{
  return (r2 > shell.inner) & (r2 <= shell.outer);
}

/// With S = ∫u uᵀ/∫1, s = S x/|x|², t = tr S/|x|² and q = x·s/|x|², half of S : ∇∇ makes of |x|^-3 (7.5 q − 1.5 t)
/// |x|^-3, of x |x|^-4 ((12 q − 2 t) x − 4 s) |x|^-4, of x xᵀ |x|^-5 ((17.5 q − 2.5 t) x xᵀ − 5 (x sᵀ + s xᵀ) + S)
/// |x|^-5.
II_VECTOR_CLONES
void sum_points(const TrianglePacket* groups, const LaneWeights* weights, const WeightedPacket* list, std::size_t count,
                const FluxSums::Shell& shell_in_memory, LaneSums& out)
{
  LaneSums sum = out;
  const FluxSums::Shell shell = shell_in_memory;
  for (std::size_t g = 0; g < count; ++g) {
    const TrianglePacket& group = groups[list[g].group];
    const LaneWeights& weight = weights[list[g].weights];
    const double *sxx = group.second[0], *sxy = group.second[1], *sxz = group.second[2], *syy = group.second[3],
                 *syz = group.second[4], *szz = group.second[5];
    for (std::size_t j = 0; j < lanes; ++j) {
      const SeenPoint p = seen_from(shell.centre, group, weight, j);
      const double x = p.x, y = p.y, z = p.z, h = holds(shell, p.r2) ? p.h : 0.0;
      const double i2 = 1 / bounded(p.r2), i1 = std::sqrt(i2);
      const Vec3 s = second_times(group, j, p) * i2;
      const double t = (sxx[j] + syy[j] + szz[j]) * i2, q = (s.x * x + s.y * y + s.z * z) * i2;
      const double h4 = h * (i2 * i2), h5 = h4 * i1;
      const double h3 = h * i2 * i1 * (1 + 7.5 * q - 1.5 * t), f4 = 1 + 12 * q - 2 * t, f5 = 0.5 + 8.75 * q - 1.25 * t;
      const double ux = f5 * x - 5 * s.x, uy = f5 * y - 5 * s.y, uz = f5 * z - 5 * s.z;
      const double hx = h * x, hy = h * y, hz = h * z, gx = h5 * x, gy = h5 * y, gz = h5 * z;
      add_moments(sum, 0, j, h, hx, hy, hz, hx * x + h * sxx[j], hx * y + h * sxy[j], hx * z + h * sxz[j],
                  hy * y + h * syy[j], hy * z + h * syz[j], hz * z + h * szz[j]);
      add_moments(sum, 10, j, h3, h4 * (f4 * x - 4 * s.x), h4 * (f4 * y - 4 * s.y), h4 * (f4 * z - 4 * s.z),
                  2 * (gx * ux) + h5 * sxx[j], gx * uy + gy * ux + h5 * sxy[j], gx * uz + gz * ux + h5 * sxz[j],
                  2 * (gy * uy) + h5 * syy[j], gy * uz + gz * uy + h5 * syz[j], 2 * (gz * uz) + h5 * szz[j]);
    }
  }
  out = sum;
}

II_VECTOR_CLONES
void sum_bare_points(const TrianglePacket* groups, const LaneWeights* weights, const WeightedPacket* list,
                     std::size_t count, const FluxSums::Shell& shell_in_memory, LaneSums& out)
{
  LaneSums sum = out;
  const FluxSums::Shell shell = shell_in_memory;
  for (std::size_t g = 0; g < count; ++g) {
    const TrianglePacket& group = groups[list[g].group];
    const LaneWeights& weight = weights[list[g].weights];
    for (std::size_t j = 0; j < lanes; ++j) {
      const SeenPoint p = seen_from(shell.centre, group, weight, j);
      const double x = p.x, y = p.y, z = p.z, h = holds(shell, p.r2) ? p.h : 0.0;
      const double i2 = 1 / bounded(p.r2), i1 = std::sqrt(i2), i4 = i2 * i2;
      const double w3 = i2 * i1, w5 = i4 * i1;
      const double hx = h * x, hy = h * y, hz = h * z;
      const double xx = hx * x, xy = hx * y, xz = hx * z, yy = hy * y, yz = hy * z, zz = hz * z;
      add_moments(sum, 0, j, h, hx, hy, hz, xx, xy, xz, yy, yz, zz);
      add_moments(sum, 10, j, h * w3, hx * i4, hy * i4, hz * i4, xx * w5, xy * w5, xz * w5, yy * w5, yz * w5, zz * w5);
    }
  }
  out = sum;
}

/// What a piece's extent makes of |x|^-3, x |x|^-4 and x xᵀ |x|^-5: 1 and half its variance times the Laplacian in its
/// plane, q = variance/|x|², c = (h/|x|)² for the unit normal. Of h n, which the latter two have besides, the part
/// along x is taken; q |x|^-3 on the diagonal of the last one is added apart.
inline double factor3(double q, double c) { return 1 + q * (4.5 - 7.5 * c); }
inline double factor4(double q, double c) { return 1 + q * (4 - 8 * c); }
inline double factor5(double q, double c) { return 1 + q * (2.5 - 7.5 * c); }

/// With b = ∫u (x·n): ∫ h f ≈ h f + b·∇f, and the same for f |x|^{−m}, whose gradient along b has the further term
/// −m (b·x)/|x|² f |x|^{−m}.
II_VECTOR_CLONES
void sum_clusters(const MultipolePacket* groups, const std::uint32_t* list, std::size_t count,
                  const FluxSums::Shell& shell_in_memory, LaneSums& out)
{
  LaneSums sum = out;
  const FluxSums::Shell shell = shell_in_memory;
  const double ox = shell.centre.x, oy = shell.centre.y, oz = shell.centre.z;
  for (std::size_t g = 0; g < count; ++g) {
    const MultipolePacket& group = groups[list[g]];
    const double *px = group.point[0], *py = group.point[1], *pz = group.point[2];
    const double *nx = group.area[0], *ny = group.area[1], *nz = group.area[2];
    const double *sxx = group.spread[0][0], *sxy = group.spread[0][1], *sxz = group.spread[0][2];
    const double *syx = group.spread[1][0], *syy = group.spread[1][1], *syz = group.spread[1][2];
    const double *szx = group.spread[2][0], *szy = group.spread[2][1], *szz = group.spread[2][2];
    const double *variance = group.variance, *inverse_area2 = group.inverse_area2;
    for (std::size_t j = 0; j < lanes; ++j) {
      const double x = px[j] - ox, y = py[j] - oy, z = pz[j] - oz;
      const double r2 = x * x + y * y + z * z;
      const double in_shell = holds(shell, r2) ? 1.0 : 0.0;
      const double h = in_shell * ((x * nx[j] + y * ny[j] + z * nz[j]) + (sxx[j] + syy[j] + szz[j]));
      const double bx = in_shell * (sxx[j] * x + syx[j] * y + szx[j] * z);
      const double by = in_shell * (sxy[j] * x + syy[j] * y + szy[j] * z);
      const double bz = in_shell * (sxz[j] * x + syz[j] * y + szz[j] * z);
      const double i2 = 1 / bounded(r2), i1 = std::sqrt(i2), i4 = i2 * i2, i5 = i4 * i1;
      const double v = variance[j], q = v * i2, c = h * h * (i2 * inverse_area2[j]), hv = h * v;
      const double w3 = i2 * i1 * factor3(q, c), w4 = i4 * factor4(q, c), w5 = i5 * factor5(q, c);
      const double beta = (bx * x + by * y + bz * z) * i2;
      const double h3 = h - 3 * beta, h4 = h - 4 * beta, beta5 = 5 * beta;
      const double hx = h * x, hy = h * y, hz = h * z;
      const double xx = hx * x + 2 * (bx * x), xy = hx * y + (bx * y + by * x), xz = hx * z + (bx * z + bz * x);
      const double yy = hy * y + 2 * (by * y), yz = hy * z + (by * z + bz * y), zz = hz * z + 2 * (bz * z);
      const double ex = beta5 * x, ey = beta5 * y, ez = beta5 * z;
      add_moments(sum, 0, j, h, hx + bx, hy + by, hz + bz, xx, xy, xz, yy, yz, zz);
      add_moments(sum, 10, j, h3 * w3, (h4 * x + bx) * w4, (h4 * y + by) * w4, (h4 * z + bz) * w4, (xx - ex * x) * w5,
                  (xy - ex * y) * w5, (xz - ex * z) * w5, (yy - ey * y) * w5, (yz - ey * z) * w5, (zz - ez * z) * w5);
      sum.value[20][j] += hv;
      sum.value[21][j] += hv * i5;
    }
  }
  out = sum;
}

/// Σ h f (1 − (r/|x|)^{d+3}) per lane: the moments, then what all three diagonal elements have besides.
II_VECTOR_CLONES
void grow_to(double r, const LaneSums& sum, double (&out)[11][lanes])
{
  const double r3 = r * r * r, r4 = r3 * r, r5 = r4 * r;
  const double power[11] = {r3, r4, r4, r4, r5, r5, r5, r5, r5, r5, r5};
  for (std::size_t i = 0; i < 11; ++i) {
    const std::size_t plain = i < 10 ? i : 20, inverse = i < 10 ? i + 10 : 21;
    for (std::size_t j = 0; j < lanes; ++j) out[i][j] = sum.value[plain][j] - power[i] * sum.value[inverse][j];
  }
}

/// A line of half width w, its middle t beyond the sphere, is within it by (w − t)²/(4 w) on average, instead of
/// max(−t, 0): more by (w − |t|)²/(4 w) as long as it is cut.
II_VECTOR_CLONES
void sum_kinks(double r, const Vec3& centre, const TrianglePacket* groups, const LaneWeights* weights,
               const WeightedPacket* list, std::size_t count, double (&out)[10][lanes])
{
  LaneSums sum;
  const Vec3 about = centre;
  for (std::size_t g = 0; g < count; ++g) {
    const TrianglePacket& group = groups[list[g].group];
    const LaneWeights& weight = weights[list[g].weights];
    for (std::size_t j = 0; j < lanes; ++j) {
      const SeenPoint p = seen_from(about, group, weight, j);
      const Vec3 s = second_times(group, j, p);
      const double w = std::sqrt(3 * bounded((s.x * p.x + s.y * p.y + s.z * p.z) / bounded(p.r2)));
      const double within = w - std::abs(std::sqrt(p.r2) - r);
      const double k = within > 0 ? p.h * (within * within) / (4 * w) : 0.0;
      const double kx = k * p.x, ky = k * p.y, kz = k * p.z;
      add_moments(sum, 0, j, k, kx, ky, kz, kx * p.x, kx * p.y, kx * p.z, ky * p.y, ky * p.z, kz * p.z);
    }
  }
  for (std::size_t i = 0; i < 10; ++i)
    for (std::size_t j = 0; j < lanes; ++j) out[i][j] = sum.value[i][j];
}

}  // namespace

SolidMoments kink_at(double r, const Vec3& centre, const TrianglePacket* groups, const LaneWeights* weights,
                     const WeightedPacket* list, std::size_t count)
{
  alignas(64) double lane[10][lanes];
  sum_kinks(r, centre, groups, weights, list, count, lane);
  double s[10];
  for (std::size_t i = 0; i < 10; ++i) s[i] = sum_of_lanes(lane[i]) * (-1 / r);
  return {s[0], {s[1], s[2], s[3]}, {s[4], s[5], s[6], s[7], s[8], s[9]}};
}

void FluxSums::add_points(const TrianglePacket* groups, const LaneWeights* weights, const WeightedPacket* list,
                          std::size_t count, const Shell& shell, Shape shape)
{
  if (count == 0) return;
  const auto sum = shape == Shape::own ? sum_points : sum_bare_points;
  sum(groups, weights, list, count, shell, lanes_);
}

void FluxSums::add_clusters(const MultipolePacket* groups, const std::uint32_t* list, std::size_t count,
                            const Shell& shell)
{
  if (count > 0) sum_clusters(groups, list, count, shell, lanes_);
}

SolidMoments FluxSums::up_to(double r) const
{
  alignas(64) double lane[11][lanes];
  grow_to(r, lanes_, lane);
  double s[11];
  for (std::size_t i = 0; i < 11; ++i) s[i] = sum_of_lanes(lane[i]);
  // The diagonal's part is given to all three axes: along the normal it is far under what stands there.
  return {s[0], {s[1], s[2], s[3]}, {s[4] + s[10], s[5], s[6], s[7] + s[10], s[8], s[9] + s[10]}};
}

}  // namespace integral_invariant
