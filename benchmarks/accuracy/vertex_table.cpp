// SPDX-License-Identifier: GPL-3.0-or-later
#include "vertex_table.h"

#include <cstdio>

#include "support/shapes.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

enum Role : char { unknown, known, judged };

std::vector<Role> roles_of(const TruthMesh& truth)
{
  std::vector<Role> roles(truth.mesh.positions.size(), unknown);
  for (const std::uint32_t v : truth.known) roles[v] = known;
  for (const std::uint32_t v : truth.judged) roles[v] = judged;
  return roles;
}

}  // namespace

void print_vertices(const TruthMesh& truth, const TriangleMesh& noisy)
{
  const double edge = test_support::average_edge_length(truth.mesh);
  const std::vector<Role> roles = roles_of(truth);
  std::puts("x,y,z,nx,ny,nz,offset,kappa_max,kappa_min,reference,role");
  for (std::size_t v = 0; v < roles.size(); ++v) {
    const Vec3 p = truth.mesh.positions[v] * (1 / edge), n = truth.normal[v];
    const double offset = dot(noisy.positions[v] - truth.mesh.positions[v], n) / edge;
    std::printf("%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%d\n", p.x, p.y, p.z, n.x, n.y, n.z, offset,
                truth.kappa_max[v] * edge, truth.kappa_min[v] * edge, truth.reference[v] * edge, roles[v]);
  }
}

}  // namespace accuracy
