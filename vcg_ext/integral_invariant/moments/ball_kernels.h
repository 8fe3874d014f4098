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

#include "integral_invariant/moments/moment_sums.h"

namespace integral_invariant {

/// Writes the points relative to `centre` and their first scale, the number of squared radii that they lie beyond.
/// Arrays of `count` rounded up to full lanes.
void place_points(const double* x, const double* y, const double* z, std::size_t count, const Vec3& centre,
                  const std::vector<double>& squared_radii, double* px, double* py, double* pz, std::int64_t* scale);

/// Corners that one sphere cuts off triangles, in columns: the lone vertex a, and b and c in the triangle's order.
class CornerBatch {
 public:
  static constexpr std::size_t lanes = 8, capacity = 64;

  bool is_full() const { return count_ == capacity; }
  std::size_t count() const { return count_; }
  /// `sign` +1 where `a` alone is inside, −1 where it alone is outside.
  void push(const Vec3& a, const Vec3& b, const Vec3& c, double sign)
  {
    const double values[columns] = {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, sign};
    for (std::size_t i = 0; i < columns; ++i) column_[i][count_] = values[i];
    ++count_;
  }
  void clear() { count_ = 0; }
  /// Fills the last group up with corners that add nothing: sign 0, along the unit vector `pole`.
  void pad(const Vec3& pole, double radius);

  static constexpr std::size_t columns = 10;
  const double* column(std::size_t i) const { return column_[i].data(); }

 private:
  std::size_t count_ = 0;
  alignas(64) std::array<std::array<double, capacity>, columns> column_;
};

/// What corners add to the moments of their ball: the cones to their straight parts, less the ball's sectors over their
/// great arcs but for the area of these.
struct CornerSums {
  MomentSums moments;
  double half_area = 0;  ///< half of the arcs' area about the pole
};

/// Adds the batch's corners and empties it. `wide`: some chord may be longer than `longest_narrow_chord` radii.
void add_corners(CornerBatch& batch, double radius, const Vec3& pole, bool wide, CornerSums& sums);

inline constexpr double longest_narrow_chord = 1.0;

}  // namespace integral_invariant
