// SPDX-License-Identifier: GPL-3.0-or-later
// A Hilbert curve through a cube. Source: J. Skilling, Programming the Hilbert curve, AIP Conf. Proc. 707, 2004.
#include "integral_invariant/mesh/hilbert_curve.h"

#include <algorithm>
#include <cstddef>

namespace integral_invariant {

namespace {

/// Bit i of x (of 21) at place 3 i.
std::uint64_t spread(std::uint64_t x)
{
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

/// All bits where `bit` of x is set, none where it is not: a branch on it would be missed half the time.
std::uint32_t mask_of(std::uint32_t x, int bit) { return 0U - (x >> bit & 1U); }

/// As many cells as vector instructions take at once.
struct Cells {
  static constexpr std::size_t count = 8;
  std::uint32_t x[count], y[count], z[count];
};

/// Exchanges and reflects the axes, from the largest octant down, so that each octant's curve starts where the one
/// before it ended.
void unfold(Cells& c)
{
  for (int bit = HilbertCurve::bits - 1; bit > 0; --bit) {
    const std::uint32_t below = (1U << bit) - 1;
    for (std::size_t i = 0; i < Cells::count; ++i) {
      std::uint32_t x = c.x[i] ^ (below & mask_of(c.x[i], bit));
      for (std::uint32_t* axis : {&c.y[i], &c.z[i]}) {
        const std::uint32_t reflected = below & mask_of(*axis, bit);
        const std::uint32_t exchanged = (x ^ *axis) & below & ~reflected;
        x ^= exchanged | reflected;
        *axis ^= exchanged;
      }
      c.x[i] = x;
    }
  }
}

/// Undoes the Gray code of an unfolded cell.
std::uint64_t index_of(std::uint32_t x, std::uint32_t y, std::uint32_t z)
{
  y ^= x;
  z ^= y;
  std::uint32_t reflected = z >> 1;  // each bit: the parity of those of z above it
  for (const int shift : {1, 2, 4, 8, 16}) reflected ^= reflected >> shift;
  return spread(x ^ reflected) << 2 | spread(y ^ reflected) << 1 | spread(z ^ reflected);
}

}  // namespace

HilbertCurve::HilbertCurve(const Vec3& centre, double half_side, const Axes& axes)
    : axes_(axes),
      low_(centre - axes.vector({half_side, half_side, half_side})),
      cells_per_length_(double(1U << bits) / (2 * half_side))
{
}

std::uint32_t HilbertCurve::cell(double offset) const
{
  const double x = offset * cells_per_length_;
  return x > 0 ? std::uint32_t(std::min(x, double((1U << bits) - 1))) : 0;  // 0 where it is not a number
}

std::vector<std::uint64_t> HilbertCurve::indices(const std::vector<Vec3>& points, Execution& execution) const
{
  std::vector<std::uint64_t> result;
  resize_in_steps(result, points.size(), execution);
  parallel_step(points.size(), 8192, execution, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t begin = first; begin < last; begin += Cells::count) {
      const std::size_t count = std::min(Cells::count, last - begin);
      Cells c{};
      for (std::size_t i = 0; i < count; ++i) {
        const Vec3 offset = axes_.coordinates_of(points[begin + i] - low_);
        c.x[i] = cell(offset.x);
        c.y[i] = cell(offset.y);
        c.z[i] = cell(offset.z);
      }
      unfold(c);
      for (std::size_t i = 0; i < count; ++i) result[begin + i] = index_of(c.x[i], c.y[i], c.z[i]);
    }
  });
  return result;
}

}  // namespace integral_invariant
