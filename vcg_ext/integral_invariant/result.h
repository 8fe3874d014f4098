// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/support/execution.h"
#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// What a run leaves, one entry a vertex of the input and in its order; every value is finite.
/// A vertex without a triangle has zero curvature, the smallest radius, an arbitrary orthonormal pair and confidence 0.
struct Result {
  std::vector<double> kappa_max, kappa_min;  ///< 1/L; kappa_max >= kappa_min; positive where the solid is convex
  std::vector<Vec3> dir_max, dir_min;        ///< unit, orthogonal to each other and to the normal
  std::vector<Vec3> normal;                  ///< unit, outward: the ball's own, not the mesh's
  std::vector<double> radius;                ///< L; of the ball that the curvatures were taken from
  std::vector<double> standard_error;  ///< 1/L; expected error of either curvature, 0 unless the radius is statistical
  std::vector<float> confidence;       ///< 0 to 1: how much of the ball's surface was there and consistently oriented

  // How it came about.
  SurfaceReport surface;
  std::vector<double> scales;             ///< radii of the scales, L
  double average_edge = 0, diagonal = 0;  ///< L
  double noise = 0;              ///< L; standard deviation along the normal, 0 unless it was estimated or given
  std::size_t outliers = 0;  ///< vertices that stood out of the surface alone, and were measured as if they lay on it
  double noise_correlation = 0;  ///< L; over which it is alike from vertex to vertex, 0 where it is independent
  std::size_t converged = 0;     ///< vertices whose radius converged; all of them when it is fixed
  double mean_iterations = 0;
  int largest_iterations = 0;
  std::string engine;  ///< what computed the moments
  std::vector<StageTime> stages;
};

}  // namespace integral_invariant
