// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: the inner loops, on arrays, compiled for several levels of vector instructions.
//
// Every loop works in groups of a fixed number of lanes and the file is compiled without contraction to fused
// multiply-add, so that all instruction sets give the same bits. Double throughout: the curvature is a difference of
// moments in which five digits cancel at large radii.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "integral_invariant/moments/solid_moments.h"
#include "integral_invariant/moments/surface/kernels/scale_search.h"

namespace integral_invariant {

/// What the cone moments of a triangle about any apex are made of, in rows of four.
struct alignas(32) LocalTriangle {
  double centroid[4];      ///< and 1
  double doubled_area[4];  ///< (b − a) × (c − a), and 0
  double square[4];        ///< xx, yy, zz of Σ (v − centroid)(v − centroid)ᵀ / 12 over the corners
  double mixed[4];         ///< xy, yz, zx of it
};

/// Moments of the cones from `centre` to those of the triangles that `list` names.
SolidMoments whole_triangles(const LocalTriangle* triangles, const std::uint32_t* list, std::size_t count,
                             const Vec3& centre);

/// Corners that one sphere cuts off triangles, in columns: the lone vertex a, and b and c in the triangle's order.
class CornerBatch {
 public:
  static constexpr std::size_t lanes = kernel_lanes, capacity = 128;

  bool is_full() const { return count_ == capacity; }
  std::size_t count() const { return count_; }
  /// `sign` +1 where `a` alone is inside, −1 where it alone is outside.
  void push(const Vec3& a, const Vec3& b, const Vec3& c, double sign)
  {
    const std::size_t i = count_;
    column_[0][i] = a.x, column_[1][i] = a.y, column_[2][i] = a.z;
    column_[3][i] = b.x, column_[4][i] = b.y, column_[5][i] = b.z;
    column_[6][i] = c.x, column_[7][i] = c.y, column_[8][i] = c.z;
    column_[9][i] = sign;
    ++count_;
  }
  void clear() { count_ = 0; }
  /// Fills the last group up with corners of the ball about `centre` that add nothing: sign 0, along the unit vector
  /// `pole`.
  void pad(const Vec3& centre, const Vec3& pole, double radius);

  static constexpr std::size_t columns = 10;
  const double* column(std::size_t i) const { return column_[i].data(); }

 private:
  std::size_t count_ = 0;
  alignas(64) std::array<std::array<double, capacity>, columns> column_;
};

/// What corners add to the moments of their ball: the cones to their straight parts, less the ball's sectors over their
/// great arcs but for the area of these.
struct CornerSums {
  SolidMoments moments;
  double half_area = 0;  ///< half of the arcs' area about the pole
};

/// Adds the batch's corners of the ball about `centre` and empties it. No chord is longer than `longest_chord`.
void add_corners(CornerBatch& batch, const Vec3& centre, double radius, const Vec3& pole, double longest_chord,
                 CornerSums& sums);

}  // namespace integral_invariant
