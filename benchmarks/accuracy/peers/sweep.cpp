// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/sweep.h"

#include <algorithm>
#include <cmath>

#include "resource_use.h"

namespace accuracy {

namespace {

/// In average edge lengths.
constexpr double radii[] = {1, 1.5, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16, 20, 25, 32, 40};
/// An error this many times the smallest one is past the optimum: from one radius to the next errors change less.
constexpr double past_optimum = 2.5;

}  // namespace

void sweep_radii(Peer& peer, const TruthMesh& truth, double edge,
                 const std::function<void(double radius, const Metrics& metrics, double seconds)>& take)
{
  std::vector<Vec3> normals;
  for (const std::uint32_t v : truth.judged) normals.push_back(truth.normal[v]);
  double mean = INFINITY, direction = INFINITY;
  for (const double radius : radii) {
    const double start = wall_seconds();
    const Metrics m = compare(truth, peer.estimate(truth.judged, normals, radius * edge));
    take(peer.takes_radius() ? radius : 0, m, wall_seconds() - start);
    mean = std::min(mean, m.mean);
    direction = std::min(direction, m.direction);
    const bool is_past = m.mean > past_optimum * mean && m.direction >= past_optimum * direction;
    if (is_past || !peer.takes_radius()) break;
  }
}

}  // namespace accuracy
