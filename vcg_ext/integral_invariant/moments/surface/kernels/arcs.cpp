// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: great arcs between the directions of edges' ends, many at once.
#include "integral_invariant/moments/surface/kernels/arcs.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/moments/surface/kernels/arc_ratio.h"
#include "integral_invariant/support/simd.h"

namespace integral_invariant {

namespace {

constexpr std::size_t lanes = kernel_lanes;

/// Per lane: the arcs' first (3) and second moments (6), and the product of complex numbers.
struct alignas(64) LaneArcs {
  double value[9][lanes] = {};
  double real[lanes], imaginary[lanes];
};

II_VECTOR_CLONES
void sum_arcs(const double* const* column, std::size_t count, const double* centre, const double* pole, LaneArcs& out)
{
  LaneArcs sums = out;
  const double *bx = column[0], *by = column[1], *bz = column[2], *cx = column[3], *cy = column[4], *cz = column[5];
  const double ox = centre[0], oy = centre[1], oz = centre[2], nx = pole[0], ny = pole[1], nz = pole[2];
  for (std::size_t group = 0; group < count; group += lanes)
    for (std::size_t j = 0; j < lanes; ++j) {
      const std::size_t i = group + j;
      const double ux = bx[i] - ox, uy = by[i] - oy, uz = bz[i] - oz, vx = cx[i] - ox, vy = cy[i] - oy, vz = cz[i] - oz;
      const double u = 1 / std::sqrt(ux * ux + uy * uy + uz * uz), v = 1 / std::sqrt(vx * vx + vy * vy + vz * vz);
      const double px = u * ux, py = u * uy, pz = u * uz, qx = v * vx, qy = v * vy, qz = v * vz;
      const double mx = py * qz - pz * qy, my = pz * qx - px * qz, mz = px * qy - py * qx;
      const double sx = px + qx, sy = py + qy, sz = pz + qz, dx = px - qx, dy = py - qy, dz = pz - qz;
      const double half_sine2 = 0.25 * (dx * dx + dy * dy + dz * dz), cosine2 = 1 - half_sine2;
      const double arc = 0.5 * any_angle_ratio(half_sine2), pair = 1 / (12 * (cosine2 > 1e-15 ? cosine2 : 1e-15));
      const double wx = pair * mx, wy = pair * my, wz = pair * mz;
      sums.value[0][j] += arc * mx;
      sums.value[1][j] += arc * my;
      sums.value[2][j] += arc * mz;
      sums.value[3][j] += 2 * (wx * sx);
      sums.value[4][j] += wx * sy + wy * sx;
      sums.value[5][j] += wx * sz + wz * sx;
      sums.value[6][j] += 2 * (wy * sy);
      sums.value[7][j] += wy * sz + wz * sy;
      sums.value[8][j] += 2 * (wz * sz);
      const double real = 0.5 * (nx * sx + ny * sy + nz * sz) + cosine2,
                   imaginary = 0.5 * (nx * mx + ny * my + nz * mz);
      const double old_real = sums.real[j], old_imaginary = sums.imaginary[j];
      sums.real[j] = old_real * real - old_imaginary * imaginary;
      sums.imaginary[j] = old_imaginary * real + old_real * imaginary;
    }
  out = sums;
}

}  // namespace

void ArcBatch::add_to(ArcSums& sums, const Vec3& centre, const Vec3& pole)
{
  if (count_ == 0) return;
  while (count_ % lanes != 0) push(centre + pole, centre + pole);
  LaneArcs lane;
  for (std::size_t j = 0; j < lanes; ++j) {
    lane.real[j] = 1;
    lane.imaginary[j] = 0;
  }
  const double* column[6];
  for (std::size_t i = 0; i < 6; ++i) column[i] = column_[i].data();
  const double apex[3] = {centre.x, centre.y, centre.z}, axis[3] = {pole.x, pole.y, pole.z};
  sum_arcs(column, count_, apex, axis, lane);
  count_ = 0;

  double s[9];
  for (std::size_t i = 0; i < 9; ++i) s[i] = sum_of_lanes(lane.value[i]);
  std::complex<double> product = 1;
  for (std::size_t j = 0; j < lanes; ++j) {
    const std::complex<double> factor(lane.real[j], lane.imaginary[j]);
    product *= factor / std::max(std::max(std::fabs(factor.real()), std::fabs(factor.imag())), 1e-300);
  }
  sums.add({{s[0], s[1], s[2]}, {s[3], s[4], s[5], s[6], s[7], s[8]}}, product);
}

}  // namespace integral_invariant
