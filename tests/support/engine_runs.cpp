// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of the surface engine that tests compare.
#include "support/engine_runs.h"

#include "integral_invariant/ball_curvature/curvature_tensor.h"

namespace test_support {

using namespace integral_invariant;

MomentTable surface_moments(const Surface& surface, const std::vector<double>& radii, const Parameters& parameters)
{
  MomentTable all(surface.vertex_count(), std::vector<BallMoments>(radii.size()));
  Execution execution(parameters.threads);
  make_surface_engine(surface, parameters, execution)
      ->evaluate(
          radii, [&](std::size_t v, int k, const BallMoments& m) { all[v][std::size_t(k)] = m; }, execution);
  return all;
}

double largest_curvature_times_radius(const BallMoments& moments, double radius)
{
  return largest_absolute_curvature(curvature_tensor(moments, radius)) * radius;
}

}  // namespace test_support
