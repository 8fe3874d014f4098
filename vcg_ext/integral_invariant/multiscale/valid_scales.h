// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: which scales of a vertex can be trusted, and substitutes for those that reach over a boundary.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "integral_invariant/ball_curvature/tensor_field.h"
#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/multiscale/noise_level.h"
#include "integral_invariant/support/execution.h"
#include "integral_invariant/support/symmetric3.h"

namespace integral_invariant {

/// Where the tensor of a (vertex, scale) comes from. Doubted: from the ball, which another sheet may cut;
/// find_valid_scales leaves none.
enum class Source : unsigned char { none, jet, ball, suspect };

/// Share of its disc that a whole ball sees at least.
constexpr double least_confidence = 0.95;

/// Of a tensor from vertices, over σ².
struct DiscVariance {
  /// Covariance of (H, (K_uu − K_vv)/2, K_uv), by rows from the diagonal on, with u = axis(the tensor's normal, as
  /// TensorField gives it) and v = normal × u.
  std::array<float, 6> curvature{};
  float normal = 0;  ///< variance of either tangential component

  static Vec3 axis(const Vec3& tensor_normal) { return any_orthogonal(tensor_normal); }
  /// The same with any unit vector u of the tangent plane.
  Symmetric3 covariance_along(const Vec3& u, const Vec3& tensor_normal) const;
  float mean() const { return curvature[0]; }
  float deviator() const { return (curvature[3] + curvature[5]) / 2; }  ///< of either component, on average
};

struct ValidScales {
  std::vector<Source> source;  ///< n × scales
  std::vector<int> largest;    ///< n: the largest scale to be used

  /// \pre the origin is vertices
  const DiscVariance& variance(std::size_t vertex, std::size_t scale) const
  {
    return variances[row[vertex] * (source.size() / row.size()) + scale];
  }
  std::vector<std::uint32_t> row;       ///< n, or empty where every ball is whole: place among those with discs
  std::vector<DiscVariance> variances;  ///< those × scales
};

/// A ball that misses more than a twentieth of its disc (the surface ends there), meets another sheet, or reaches over
/// a crease gives way to a fit to vertices of what is left of the disc, which ends at creases. So does a ball that is
/// somewhat smaller than one that meets another sheet, where it contradicts the disc: what it misses of the solid hides
/// in the noise. What a quadric does not fit, and larger discs, say nothing. `offsets` are those of
/// offset_free_measure(), scale by scale for each vertex. A vertex's largest scale is the one before balls stop being
/// nearly a half: where |κ| r passes 1.3 or the normal turns away, because the ball meets another sheet or the whole of
/// a small part; on a crease it is the smallest that noise leaves. Changes `tensors` where the origin is vertices. Cost
/// O(n · scales), and 15 µs a vertex whose largest balls give way.
ValidScales find_valid_scales(const Surface& surface, const std::vector<float>& offsets, const std::vector<Jet>& fits,
                              const NoiseLevel& noise, bool removes_bias, TensorField& tensors, Execution& execution);

}  // namespace integral_invariant
