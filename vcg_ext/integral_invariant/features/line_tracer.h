// SPDX-License-Identifier: GPL-3.0-or-later
// Features: traces one line of curvature after the other, each at a distance from those before.
#pragma once

#include <vector>

#include "integral_invariant/features/curvature_lines.h"
#include "integral_invariant/features/point_grid.h"
#include "integral_invariant/features/surface_walk.h"

namespace integral_invariant {

/// Lengths in normalised units.
struct TracerOptions {
  DirectionFamily family;
  double spacing, minimum_length, umbilic;
};

class LineTracer {
 public:
  /// `lines`: unit directions of the vertices without sign; `clarity`: anisotropy() of the vertices. Both must outlive
  /// this.
  LineTracer(const Surface& surface, const Topology& topology, const std::vector<Vec3>& lines,
             const std::vector<double>& clarity, const TracerOptions& options);

  /// Whether no line is nearer to the place than `part` of the spacing.
  bool has_room(const WalkState& seed, double part) const;

  /// The line through the seed, both ways; false (and nothing kept) where it is too short.
  bool trace(const WalkState& seed, CurvatureLine& line);

  /// Places at the spacing to both sides of the line that trace() returned last.
  std::vector<WalkState> seeds_beside() const;

 private:
  struct Half {
    std::vector<SurfacePoint> points;  ///< without the seed
    std::vector<WalkState> states;     ///< at the points
    LineEnd end = LineEnd::length;
    double length = 0;
  };

  Half half_line(const WalkState& seed, const Vec3& direction, double sign);
  bool is_umbilic(const WalkState& state) const;
  bool closes(const Vec3& from, const Vec3& to, double arc) const;
  bool comes_too_near(const Vec3& position, const WalkState& state, double arc) const;
  void add_sample(const LineSample& sample);
  void add_samples(const Vec3& from, const Vec3& to, const Vec3& normal, double arc, double sign);

  const Surface& surface_;
  SurfaceWalk walk_;
  const std::vector<Vec3>& lines_;
  const std::vector<double>& clarity_;
  TracerOptions options_;
  const std::size_t most_steps_;  ///< of half a line
  PointGrid grid_;
  std::int32_t line_ = -1;              ///< the one in work
  double unsampled_ = 0;                ///< way since the last sample
  std::vector<Vec3> own_samples_;       ///< of it, taken back where it is dropped
  std::vector<WalkState> last_states_;  ///< along the line that trace() returned last
  Vec3 start_, start_direction_;
};

}  // namespace integral_invariant
