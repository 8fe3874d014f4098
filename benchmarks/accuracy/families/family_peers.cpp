// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/family_peers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "families/families.h"
#include "integral_invariant/pipeline.h"
#include "peers/peer.h"
#include "support/shapes.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

/// In average edges.
constexpr double radii[] = {1.5, 2, 3, 4, 5, 7, 9, 12, 16, 20, 25, 32, 40};
constexpr std::size_t judged_vertices = 100;
/// The sweep ends where both errors are this many times the least so far: from there on they only grow, and the largest
/// radii take the most time.
constexpr double hopeless = 2.5;

struct Best {
  double mean = INFINITY, mean_radius = 0, direction = INFINITY, direction_radius = 0;

  void take(const Metrics& m, double radius)
  {
    if (m.mean < mean) mean = m.mean, mean_radius = radius;
    if (m.direction < direction) direction = m.direction, direction_radius = radius;
  }
};

void print(const FamilyCell& cell, const std::string& method, const Best& best)
{
  std::printf("%s,%s,%.4g,%s,%.5g,%g,%.4g,%g\n", cell.family.c_str(), cell.shape.name.c_str(), cell.level,
              method.c_str(), best.mean, best.mean_radius, best.direction, best.direction_radius);
  std::fflush(stdout);
}

Best ours(const TruthMesh& truth)
{
  const Result r = compute_curvature(truth.mesh, {});
  std::vector<Estimate> estimates;
  for (const std::uint32_t v : truth.judged)
    estimates.push_back({r.kappa_max[v], r.kappa_min[v], r.dir_max[v], r.standard_error[v]});
  Best best;
  best.take(compare(truth, estimates), 0);
  return best;
}

void measure_cell(const FamilyCell& cell)
{
  TruthMesh truth = cell.make(cell);
  // They are in the order of their numbers: take them evenly.
  const std::size_t stride = std::max<std::size_t>(1, truth.judged.size() / judged_vertices);
  std::vector<std::uint32_t> judged;
  for (std::size_t i = 0; i < truth.judged.size(); i += stride) judged.push_back(truth.judged[i]);
  truth.judged = judged;
  const double edge = test_support::average_edge_length(truth.mesh);
  std::vector<Vec3> normals;
  for (const std::uint32_t v : truth.judged) normals.push_back(truth.normal[v]);

  print(cell, "ours", ours(truth));
  PeerList peers;
  add_vcg_quadric_peer(truth.mesh, peers);
  add_cgal_jet_peers(truth.mesh, peers);
  add_corrected_current_peers(truth.mesh, peers);
  add_algebraic_sphere_peer(truth.mesh, peers);
  for (const auto& peer : peers) {
    Best best;
    for (const double radius : radii) {
      const Metrics m = compare(truth, peer->estimate(truth.judged, normals, radius * edge));
      best.take(m, radius);
      if (m.mean > hopeless * best.mean && m.direction >= hopeless * best.direction) break;
    }
    print(cell, peer->name(), best);
  }
}

}  // namespace

void run_family_peers(int argc, char** argv)
{
  std::uint32_t seed = 1;
  std::string filter;
  for (int i = 2; i < argc; i += 2) {
    const std::string option = argv[i];
    if (i + 1 == argc || (option != "--seed" && option != "--cells"))
      throw std::invalid_argument("usage: accuracy family_peers [--seed N] [--cells TEXT]");
    if (option == "--seed") seed = std::uint32_t(std::stoul(argv[i + 1]));
    if (option == "--cells") filter = argv[i + 1];
  }
  std::puts("family,shape,level,method,mean,mean_radius,direction,direction_radius");
  for (const FamilyCell& cell : draw_peer_cells(seed))
    if (cell.name().find(filter) != std::string::npos) measure_cell(cell);
}

}  // namespace accuracy
