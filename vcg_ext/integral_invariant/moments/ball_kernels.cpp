// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the inner loops, on arrays, compiled for several levels of vector instructions.
#include "integral_invariant/moments/ball_kernels.h"

#include <algorithm>
#include <cmath>
#include <complex>

// One binary for old and new processors: the loader picks the clone. Elsewhere the compiler's default target is used.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__)
#define II_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define II_VECTOR_CLONES
#endif

namespace integral_invariant {

namespace {

constexpr std::size_t lanes = CornerBatch::lanes;

/// Sums per lane: volume, first (3), second (6), and the product of complex numbers.
struct alignas(64) LaneSums {
  double value[10][lanes] = {};
  double real[lanes], imaginary[lanes];
};

/// θ/sin θ as a series in t = sin²(θ/2): Π 2j/(2j+1) t^k. The 17 terms are exact to 1e-15 up to t = 0.147, to 3e-11 up to
/// t = 0.25, a chord of one radius: far under what is asked of "exact".
inline double narrow_ratio(double t)
{
  double sum = 0;
  constexpr int terms = 17;
  double factor[terms] = {1};
  for (int k = 1; k < terms; ++k) factor[k] = factor[k - 1] * (2.0 * k) / (2.0 * k + 1);
#pragma GCC unroll 17
  for (int k = terms - 1; k >= 0; --k) sum = sum * t + factor[k];
  return sum;
}

/// The same for any t < 1: halving the angle twice brings t under 0.147.
inline double wide_ratio(double t)
{
  const double cosine = std::sqrt(std::fmax(1 - t, 1e-15)), half = t / (2 * (1 + cosine));
  const double half_cosine = std::sqrt(1 - half), quarter = half / (2 * (1 + half_cosine));
  return narrow_ratio(quarter) / (cosine * half_cosine);
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

template <bool wide>
[[gnu::always_inline]] inline void add_groups(const CornerBatch& batch, double radius, const Vec3& pole, LaneSums& sums)
{
  const double r2 = radius * radius, inverse_r = 1 / radius, inverse_r2 = inverse_r * inverse_r;
  const double *ax = batch.column(0), *ay = batch.column(1), *az = batch.column(2);
  const double *bx = batch.column(3), *by = batch.column(4), *bz = batch.column(5);
  const double *cx = batch.column(6), *cy = batch.column(7), *cz = batch.column(8), *signs = batch.column(9);
  const double nx = pole.x * inverse_r, ny = pole.y * inverse_r, nz = pole.z * inverse_r;
  for (std::size_t group = 0; group < batch.count(); group += lanes) {
    for (std::size_t j = 0; j < lanes; ++j) {
      const std::size_t i = group + j;
      const double x = ax[i], y = ay[i], z = az[i], sign = signs[i];
      const double ux = bx[i] - x, uy = by[i] - y, uz = bz[i] - z;
      const double vx = cx[i] - x, vy = cy[i] - y, vz = cz[i] - z;
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
      const double ratio = wide ? wide_ratio(half_sine2) : narrow_ratio(half_sine2);
      const double cosine2 = 1 - half_sine2;
      const double arc = 3 * r2 * sign * ratio, pair = 2 * r2 * sign / (cosine2 > 1e-15 ? cosine2 : 1e-15);
      const double gx = x + sx, gy = y + sy, gz = z + sz;
      sums.value[0][j] += cone;
      sums.value[1][j] += cone * gx - arc * mx;
      sums.value[2][j] += cone * gy - arc * my;
      sums.value[3][j] += cone * gz - arc * mz;
      sums.value[4][j] += cone * (x * x + px * px + qx * qx + gx * gx) - pair * (2 * mx * sx);
      sums.value[5][j] += cone * (x * y + px * py + qx * qy + gx * gy) - pair * (mx * sy + my * sx);
      sums.value[6][j] += cone * (x * z + px * pz + qx * qz + gx * gz) - pair * (mx * sz + mz * sx);
      sums.value[7][j] += cone * (y * y + py * py + qy * qy + gy * gy) - pair * (2 * my * sy);
      sums.value[8][j] += cone * (y * z + py * pz + qy * qz + gy * gz) - pair * (my * sz + mz * sy);
      sums.value[9][j] += cone * (z * z + pz * pz + qz * qz + gz * gz) - pair * (2 * mz * sz);
      // Halved, so that a product over a batch stays near 1 for arcs near the pole's equator.
      const double real = 0.5 * (nx * sx + ny * sy + nz * sz) + cosine2;
      const double imaginary = 0.5 * inverse_r * sign * (nx * mx + ny * my + nz * mz);
      const double old_real = sums.real[j], old_imaginary = sums.imaginary[j];
      sums.real[j] = old_real * real - old_imaginary * imaginary;
      sums.imaginary[j] = old_imaginary * real + old_real * imaginary;
    }
  }
}

II_VECTOR_CLONES void add_narrow(const CornerBatch& batch, double radius, const Vec3& pole, LaneSums& sums)
{
  add_groups<false>(batch, radius, pole, sums);
}

II_VECTOR_CLONES void add_wide(const CornerBatch& batch, double radius, const Vec3& pole, LaneSums& sums)
{
  add_groups<true>(batch, radius, pole, sums);
}

double sum_of(const double* lane)
{
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

}  // namespace

II_VECTOR_CLONES
void place_points(const double* x, const double* y, const double* z, std::size_t count, const Vec3& centre,
                  const std::vector<double>& squared_radii, double* px, double* py, double* pz, std::int64_t* scale)
{
  const double* limits = squared_radii.data();
  const std::size_t scales = squared_radii.size();
  const double cx = centre.x, cy = centre.y, cz = centre.z;
  for (std::size_t group = 0; group < count; group += lanes) {
    double d2[lanes];
    std::int64_t beyond[lanes] = {};
    for (std::size_t j = 0; j < lanes; ++j) {
      const double dx = x[group + j] - cx, dy = y[group + j] - cy, dz = z[group + j] - cz;
      px[group + j] = dx;
      py[group + j] = dy;
      pz[group + j] = dz;
      d2[j] = dx * dx + dy * dy + dz * dz;
    }
    for (std::size_t k = 0; k < scales; ++k)
      for (std::size_t j = 0; j < lanes; ++j) beyond[j] += d2[j] > limits[k] ? 1 : 0;
    for (std::size_t j = 0; j < lanes; ++j) scale[group + j] = beyond[j];
  }
}

void CornerBatch::pad(const Vec3& pole, double radius)
{
  const Vec3 beyond = pole * (2 * radius);
  while (count_ % lanes != 0) push({}, beyond, beyond, 0);
}

void add_corners(CornerBatch& batch, double radius, const Vec3& pole, bool wide, CornerSums& sums)
{
  if (batch.count() == 0) return;
  batch.pad(pole, radius);
  LaneSums lane_sums;
  for (std::size_t j = 0; j < lanes; ++j) {
    lane_sums.real[j] = 1;
    lane_sums.imaginary[j] = 0;
  }
  wide ? add_wide(batch, radius, pole, lane_sums) : add_narrow(batch, radius, pole, lane_sums);
  batch.clear();

  double total[10];
  for (std::size_t i = 0; i < 10; ++i) total[i] = sum_of(lane_sums.value[i]);
  constexpr double f = 1.0 / 24, s = 1.0 / 120;
  sums.moments += {total[0] / 6,
                   {f * total[1], f * total[2], f * total[3]},
                   {s * total[4], s * total[5], s * total[6], s * total[7], s * total[8], s * total[9]}};
  std::complex<double> product = 1;
  for (std::size_t j = 0; j < lanes; ++j) {
    product *= std::complex<double>(lane_sums.real[j], lane_sums.imaginary[j]);
    product *= 1 / std::max({std::abs(product.real()), std::abs(product.imag()), 1e-300});
  }
  sums.half_area += std::arg(product);
}

}  // namespace integral_invariant
