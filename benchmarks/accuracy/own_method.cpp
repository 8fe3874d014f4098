// SPDX-License-Identifier: GPL-3.0-or-later
#include "own_method.h"

#include "resource_use.h"

namespace accuracy {

using namespace integral_invariant;

OwnResult measure_own(const TruthMesh& truth, const Parameters& parameters)
{
  const double start = wall_seconds();
  const Result r = compute_curvature(truth.mesh, parameters);
  OwnResult own;
  own.seconds = wall_seconds() - start;
  own.noise = r.noise;
  own.average_edge = r.average_edge;
  std::vector<Estimate> estimates;
  for (const std::uint32_t v : truth.judged)
    estimates.push_back({r.kappa_max[v], r.kappa_min[v], r.dir_max[v], r.standard_error[v]});
  own.metrics = compare(truth, estimates);
  return own;
}

}  // namespace accuracy
