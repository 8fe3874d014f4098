// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: sums of fluxes over the points that stand for distant surface (rules: clip.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "integral_invariant/moments/solid_moments.h"
#include "integral_invariant/moments/surface/kernels/scale_search.h"

namespace integral_invariant {

/// Triangles, one a lane, each by its centroid, its area vector ∫n and its second moments, the mean of u uᵀ with u from
/// the centroid (xx, xy, xz, yy, yz, zz).
struct alignas(64) TrianglePacket {
  double point[3][kernel_lanes], area[3][kernel_lanes], second[6][kernel_lanes];

  void set(std::size_t lane, const std::array<Vec3, 3>& v)
  {
    const Vec3 p = (v[0] + v[1] + v[2]) * (1.0 / 3), n = cross(v[1] - v[0], v[2] - v[0]) * 0.5;
    point[0][lane] = p.x, point[1][lane] = p.y, point[2][lane] = p.z;
    area[0][lane] = n.x, area[1][lane] = n.y, area[2][lane] = n.z;
    const Symmetric3 s = (outer(v[0] - p) + outer(v[1] - p) + outer(v[2] - p)) * (1.0 / 12);
    second[0][lane] = s.xx, second[1][lane] = s.xy, second[2][lane] = s.xz;
    second[3][lane] = s.yy, second[4][lane] = s.yz, second[5][lane] = s.zz;
  }
};

/// Larger pieces by a point, ∫n, spread[k] = ∫u n_k, u from the point, and the variance if they are about flat.
struct alignas(64) MultipolePacket {
  double point[3][kernel_lanes], area[3][kernel_lanes], variance[kernel_lanes], inverse_area2[kernel_lanes];
  double spread[3][3][kernel_lanes];

  void set(std::size_t lane, const Vec3& p, const Vec3& n, const Vec3 (&u)[3], double variance_of_u)
  {
    variance[lane] = variance_of_u;
    inverse_area2[lane] = squared_norm(n) > 1e-300 ? 1 / squared_norm(n) : 0;
    point[0][lane] = p.x, point[1][lane] = p.y, point[2][lane] = p.z;
    area[0][lane] = n.x, area[1][lane] = n.y, area[2][lane] = n.z;
    for (int k = 0; k < 3; ++k) spread[k][0][lane] = u[k].x, spread[k][1][lane] = u[k].y, spread[k][2][lane] = u[k].z;
  }
};

struct alignas(64) LaneWeights {
  double weight[kernel_lanes];
};

/// A group of points and its weights, by their places in arrays.
struct WeightedPacket {
  std::uint32_t group, weights;
};

/// Sums over triangles of h f and h f |x|^{−(d+3)} for f = 1, x, x xᵀ, of degree d: x is a triangle's centroid from the
/// balls' centre, h = x·∫n. A triangle counts by the integrand at its centroid and, with its shape, half its second
/// moments times the integrand's second derivatives; a cluster by the integrand, its gradient and, as if it were round,
/// half its variance times the integrand's Laplacian in its plane.
class FluxSums {
 public:
  /// What lies in a shell about `centre`: squared distances over `inner` and not over `outer`.
  struct Shell {
    Vec3 centre;
    double inner, outer;
  };

  /// With their second moments, or as mere points.
  enum class Shape { own, none };

  void add_points(const TrianglePacket* groups, const LaneWeights* weights, const WeightedPacket* list,
                  std::size_t count, const Shell& shell, Shape shape);
  void add_clusters(const MultipolePacket* groups, const std::uint32_t* list, std::size_t count, const Shell& shell);
  /// Σ h f (1 − (r/|x|)^{d+3}).
  SolidMoments up_to(double r) const;

  static constexpr std::size_t sums = 22;
  /// Per lane: ten moments of h f, the same of h f |x|^{−(d+3)}, and what all three diagonal elements of each have
  /// besides.
  struct alignas(64) Lanes {
    double value[sums][kernel_lanes] = {};
  };

 private:
  Lanes lanes_;
};

/// What Σ h f (1 − (r/|x|)^{d+3}) / (d+3) lacks where the sphere r about `centre` cuts triangles. The integrand falls
/// to nothing there and stays nothing beyond, so that its mean over a triangle is not its value at the centroid.
/// Triangles count as lines of their own variance along x.
SolidMoments kink_at(double r, const Vec3& centre, const TrianglePacket* groups, const LaneWeights* weights,
                     const WeightedPacket* list, std::size_t count);

}  // namespace integral_invariant
