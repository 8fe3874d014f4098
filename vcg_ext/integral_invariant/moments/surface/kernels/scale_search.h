// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: which scales points and spheres belong to, as inner loops on arrays; for their rules see
// clip.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "integral_invariant/support/simd.h"
#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// Spheres in columns, filled up to full lanes.
class SphereColumns {
 public:
  void clear();
  void push(const Vec3& centre, double radius);
  /// Those of `from` that `list` names, padded.
  void take(const SphereColumns& from, const std::uint32_t* list, std::size_t count);
  /// After the last push.
  void pad();
  std::size_t size() const { return size_; }

  std::vector<double> x, y, z, radius;

 private:
  std::size_t size_ = 0;
};

/// Per sphere the numbers of radii that are smaller than its least and than its largest distance from the points within
/// `extent` of `centre`: where they are the same, no ball about those points cuts it. Arrays of full lanes.
void find_scale_ranges(const SphereColumns& spheres, const Vec3& centre, double extent,
                       const std::vector<double>& radii, std::uint8_t* least, std::uint8_t* largest);

/// Writes the first scale of the points of `groups`, the number of squared radii that they lie beyond from `centre`.
/// Group g are the points [g·lanes, (g+1)·lanes).
void find_scales(const double* x, const double* y, const double* z, const std::vector<std::uint32_t>& groups,
                 const Vec3& centre, const std::vector<double>& squared_radii, std::uint8_t* scale);

}  // namespace integral_invariant
