// SPDX-License-Identifier: GPL-3.0-or-later
// Features: walking over the triangles, straight on or along a field of directions.
#pragma once

#include <array>
#include <vector>

#include "integral_invariant/features/surface_point.h"
#include "integral_invariant/features/topology.h"

namespace integral_invariant {

/// A place in a triangle, and the way there.
struct WalkState {
  std::int32_t triangle = -1;       ///< -1: over the boundary
  std::array<double, 3> weights{};  ///< barycentric
  Vec3 direction;                   ///< unit, in the plane of the triangle

  bool is_on_surface() const { return triangle >= 0; }
};

/// The surface as a place to walk on. Cheap to make from what it refers to; const and thread-safe.
class SurfaceWalk {
 public:
  SurfaceWalk(const Surface& surface, const Topology& topology) : surface_(surface), topology_(topology) {}

  SurfacePoint point(const WalkState& state) const { return {surface_.triangles()[state.triangle], state.weights}; }
  Vec3 position(const WalkState& state) const { return interpolate(surface_.positions(), point(state)); }
  Vec3 normal(const WalkState& state) const { return frame(state.triangle).normal; }
  TriangleFrame frame(std::int32_t triangle) const { return {surface_.triangles()[triangle], surface_.positions()}; }

  /// Straight on for `distance` (1 = ē), unfolding the triangles on the way.
  WalkState straight(WalkState state, double distance) const;

  /// From the state's place through its triangle along `lines`, which have no sign: the one that agrees with the
  /// state's direction is taken. Midpoint rule: the direction halfway leads from entry to exit. The new state stands at
  /// the entry of the next triangle. `inside` receives the place where the triangle is left.
  WalkState along(const WalkState& state, const std::vector<Vec3>& lines, SurfacePoint& inside) const;

 private:
  struct Exit {
    double distance;
    int corner;  ///< the vertex opposite to the side where the triangle is left; -1: none is reached
  };

  Exit exit_of(const WalkState& state, const TriangleFrame& frame) const;
  std::array<double, 3> advanced(const WalkState& state, const TriangleFrame& frame, double distance) const;
  Vec3 direction_at(const WalkState& state, const TriangleFrame& frame, const std::vector<Vec3>& lines) const;
  /// Over the side opposite to `corner`, with the direction unfolded.
  WalkState across(const WalkState& state, int corner) const;
  /// On from a vertex into the triangle around it that the direction points into.
  WalkState from_vertex(std::int32_t vertex, const Vec3& direction) const;

  const Surface& surface_;
  const Topology& topology_;
};

/// The direction of a line field at a point, of length up to 1, signed to agree with `like`.
Vec3 aligned_direction(const SurfacePoint& point, const std::vector<Vec3>& lines, const Vec3& like);

/// Whether the three directions of a triangle cannot be signed alike: an umbilic lies inside.
bool is_singular(const Triangle& t, const std::vector<Vec3>& lines);

}  // namespace integral_invariant
