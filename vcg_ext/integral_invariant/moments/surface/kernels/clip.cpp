// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the inner loops, on arrays, compiled for several levels of vector instructions.
#include "integral_invariant/moments/surface/kernels/clip.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/moments/surface/kernels/arc_ratio.h"
#include "integral_invariant/support/simd.h"

namespace integral_invariant {

namespace {

constexpr std::size_t lanes = kernel_lanes;

/// Sums per lane: volume, first (3), second (6), and the product of complex numbers.
struct alignas(64) LaneSums {
  double value[10][lanes] = {};
  double real[lanes], imaginary[lanes];
};

/// Enough for chords of any length.
constexpr int any_terms = 0;
/// Terms for chords of up to 1, 1/2 and 1/4 radius: the first one left out is 1e-11, 3e-13, 6e-14, far under what is
/// asked of "exact".
constexpr int terms_1 = 17, terms_2 = 10, terms_4 = 7;

template <int terms>
inline double ratio(double t)
{
  if constexpr (terms == any_terms)
    return any_angle_ratio(t);
  else
    return angle_ratio<terms>(t);
}

/// As edge_crossing(): the form of the root that subtracts nothing, chosen without a branch.
inline double crossing(double along, double length2, double depth)
{
  const double disc = along * along + length2 * depth;
  const double q = std::fabs(along) + std::sqrt(disc > 0 ? disc : 0.0);
  const bool near_root = depth >= 0 && along < 0;
  const double numerator = near_root ? q : std::fabs(depth), denominator = near_root ? length2 : q;
  const double t = numerator / (denominator > 1e-300 ? denominator : 1e-300);
  return t < 1 ? t : 1;
}

template <int terms>
[[gnu::always_inline]] inline void add_groups(const CornerBatch& batch, const Vec3& centre, double radius,
                                              const Vec3& pole, LaneSums& sums)
{
  const double r2 = radius * radius, inverse_r = 1 / radius, inverse_r2 = inverse_r * inverse_r;
  const double *ax = batch.column(0), *ay = batch.column(1), *az = batch.column(2);
  const double *bx = batch.column(3), *by = batch.column(4), *bz = batch.column(5);
  const double *cx = batch.column(6), *cy = batch.column(7), *cz = batch.column(8), *signs = batch.column(9);
  const double ox = centre.x, oy = centre.y, oz = centre.z;
  const double nx = pole.x * inverse_r, ny = pole.y * inverse_r, nz = pole.z * inverse_r;
  for (std::size_t group = 0; group < batch.count(); group += lanes) {
    for (std::size_t j = 0; j < lanes; ++j) {
      const std::size_t i = group + j;
      const double x = ax[i] - ox, y = ay[i] - oy, z = az[i] - oz, sign = signs[i];
      const double ux = bx[i] - ax[i], uy = by[i] - ay[i], uz = bz[i] - az[i];
      const double vx = cx[i] - ax[i], vy = cy[i] - ay[i], vz = cz[i] - az[i];
      const double depth = r2 - (x * x + y * y + z * z);
      const double t = crossing(x * ux + y * uy + z * uz, ux * ux + uy * uy + uz * uz, depth);
      const double s = crossing(x * vx + y * vy + z * vz, vx * vx + vy * vy + vz * vz, depth);
      const double det = x * (uy * vz - uz * vy) + y * (uz * vx - ux * vz) + z * (ux * vy - uy * vx);
      const double cone = sign * det * (t * s);
      const double px = x + t * ux, py = y + t * uy, pz = z + t * uz;
      const double qx = x + s * vx, qy = y + s * vy, qz = z + s * vz;
      // Arc from p to q: cross product, sum, sin²(θ/2).
      const double mx = py * qz - pz * qy, my = pz * qx - px * qz, mz = px * qy - py * qx;
      const double sx = px + qx, sy = py + qy, sz = pz + qz;
      const double dx = px - qx, dy = py - qy, dz = pz - qz;
      const double half_sine2 = (dx * dx + dy * dy + dz * dz) * (0.25 * inverse_r2);
      const double cosine2 = 1 - half_sine2;
      const double arc = 3 * r2 * sign * ratio<terms>(half_sine2),
                   pair = 2 * r2 * sign / (cosine2 > 1e-15 ? cosine2 : 1e-15);
      sums.value[0][j] += cone;
      sums.value[1][j] += cone * (x + sx) - arc * mx;
      sums.value[2][j] += cone * (y + sy) - arc * my;
      sums.value[3][j] += cone * (z + sz) - arc * mz;
      // With e = a + s/2: aaᵀ + ppᵀ + qqᵀ + (a+s)(a+s)ᵀ = 2eeᵀ + ssᵀ + ½ddᵀ, and ssᵀ shares its factor with the arc's
      // term.
      const double ex = x + 0.5 * sx, ey = y + 0.5 * sy, ez = z + 0.5 * sz;
      const double twice = 2 * cone, half = 0.5 * cone;
      const double fx = twice * ex, fy = twice * ey, fz = twice * ez, gx = half * dx, gy = half * dy, gz = half * dz;
      const double wx = half * sx - pair * mx, wy = half * sy - pair * my, wz = half * sz - pair * mz;
      sums.value[4][j] += fx * ex + gx * dx + 2 * (wx * sx);
      sums.value[5][j] += fx * ey + gx * dy + (wx * sy + wy * sx);
      sums.value[6][j] += fx * ez + gx * dz + (wx * sz + wz * sx);
      sums.value[7][j] += fy * ey + gy * dy + 2 * (wy * sy);
      sums.value[8][j] += fy * ez + gy * dz + (wy * sz + wz * sy);
      sums.value[9][j] += fz * ez + gz * dz + 2 * (wz * sz);
      // Halved, so that a product over a batch stays near 1 for arcs near the pole's equator.
      const double real = 0.5 * (nx * sx + ny * sy + nz * sz) + cosine2;
      const double imaginary = 0.5 * inverse_r * sign * (nx * mx + ny * my + nz * mz);
      const double old_real = sums.real[j], old_imaginary = sums.imaginary[j];
      sums.real[j] = old_real * real - old_imaginary * imaginary;
      sums.imaginary[j] = old_imaginary * real + old_real * imaginary;
    }
  }
}

II_VECTOR_CLONES void add_any_chords(const CornerBatch& batch, const Vec3& centre, double radius, const Vec3& pole,
                                     LaneSums& sums)
{
  add_groups<any_terms>(batch, centre, radius, pole, sums);
}

II_VECTOR_CLONES void add_long_chords(const CornerBatch& batch, const Vec3& centre, double radius, const Vec3& pole,
                                      LaneSums& sums)
{
  add_groups<terms_1>(batch, centre, radius, pole, sums);
}

II_VECTOR_CLONES void add_short_chords(const CornerBatch& batch, const Vec3& centre, double radius, const Vec3& pole,
                                       LaneSums& sums)
{
  add_groups<terms_2>(batch, centre, radius, pole, sums);
}

II_VECTOR_CLONES void add_tiny_chords(const CornerBatch& batch, const Vec3& centre, double radius, const Vec3& pole,
                                      LaneSums& sums)
{
  add_groups<terms_4>(batch, centre, radius, pole, sums);
}

}  // namespace

II_VECTOR_CLONES
static void sum_whole_triangles(const LocalTriangle* triangles, const std::uint32_t* list, std::size_t count,
                                const double* centre, double* sums)
{
  double first[4] = {}, square[4] = {}, mixed[4] = {};
  for (std::size_t i = 0; i < count; ++i) {
    const LocalTriangle& t = triangles[list[i]];
    double y[4], product[4];
    for (int j = 0; j < 4; ++j) y[j] = t.centroid[j] - centre[j];
    for (int j = 0; j < 4; ++j) product[j] = t.doubled_area[j] * y[j];
    const double det = (product[0] + product[1]) + product[2], turned[4] = {y[1], y[2], y[0], y[3]};
    for (int j = 0; j < 4; ++j) first[j] += y[j] * det;
    for (int j = 0; j < 4; ++j) square[j] += (t.square[j] + y[j] * y[j]) * det;
    for (int j = 0; j < 4; ++j) mixed[j] += (t.mixed[j] + y[j] * turned[j]) * det;
  }
  for (int j = 0; j < 4; ++j) {
    sums[j] = first[j];
    sums[4 + j] = square[j];
    sums[8 + j] = mixed[j];
  }
}

SolidMoments whole_triangles(const LocalTriangle* triangles, const std::uint32_t* list, std::size_t count,
                             const Vec3& centre)
{
  const double apex[4] = {centre.x, centre.y, centre.z, 0};
  double s[12];
  sum_whole_triangles(triangles, list, count, apex, s);
  constexpr double v = 1.0 / 6, f = 0.125, q = 0.1;
  return {v * s[3], {f * s[0], f * s[1], f * s[2]}, {q * s[4], q * s[8], q * s[10], q * s[5], q * s[9], q * s[6]}};
}

void CornerBatch::pad(const Vec3& centre, const Vec3& pole, double radius)
{
  const Vec3 beyond = centre + pole * (2 * radius);
  while (count_ % lanes != 0) push(centre, beyond, beyond, 0);
}

void add_corners(CornerBatch& batch, const Vec3& centre, double radius, const Vec3& pole, double longest_chord,
                 CornerSums& sums)
{
  if (batch.count() == 0) return;
  batch.pad(centre, pole, radius);
  LaneSums lane;
  for (std::size_t j = 0; j < lanes; ++j) {
    lane.real[j] = 1;
    lane.imaginary[j] = 0;
  }
  const auto add = longest_chord <= 0.25 * radius  ? add_tiny_chords
                   : longest_chord <= 0.5 * radius ? add_short_chords
                   : longest_chord <= radius       ? add_long_chords
                                                   : add_any_chords;
  add(batch, centre, radius, pole, lane);
  batch.clear();

  double total[10];
  for (std::size_t i = 0; i < 10; ++i) total[i] = sum_of_lanes(lane.value[i]);
  constexpr double f = 1.0 / 24, s = 1.0 / 120;
  sums.moments += {total[0] / 6,
                   {f * total[1], f * total[2], f * total[3]},
                   {s * total[4], s * total[5], s * total[6], s * total[7], s * total[8], s * total[9]}};
  double real = 1, imaginary = 0;
  for (std::size_t j = 0; j < lanes; ++j) {
    const double scale = 1 / std::max(std::max(std::fabs(lane.real[j]), std::fabs(lane.imaginary[j])), 1e-300);
    const double re = lane.real[j] * scale, im = lane.imaginary[j] * scale, old = real;
    real = real * re - imaginary * im;
    imaginary = old * im + imaginary * re;
  }
  sums.half_area += std::atan2(imaginary, real);
}

}  // namespace integral_invariant
