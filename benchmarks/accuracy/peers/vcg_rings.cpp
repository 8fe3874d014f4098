// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/vcg_mesh.h"

#include <vcg/complex/algorithms/update/curvature.h>
#include <vcg/complex/algorithms/update/curvature_fitting.h>

#include "peers/peer.h"

namespace accuracy {

using namespace peers;

namespace {

using Run = void (*)(VcgMesh&);

/// An estimator that looks at the ring around each vertex and has no radius.
class VcgRings : public Peer {
 public:
  VcgRings(const TriangleMesh& mesh, std::string name, Run run, double sign) : name_(std::move(name)), sign_(sign)
  {
    fill(mesh_, mesh);
    run(mesh_);
  }
  std::string name() const override { return name_; }
  bool takes_radius() const override { return false; }
  std::vector<Estimate> estimate(const std::vector<std::uint32_t>& vertices, const std::vector<Vec3>&, double) override
  {
    std::vector<Estimate> result;
    for (const std::uint32_t i : vertices) {
      const VcgVertex& v = mesh_.vert[i];
      result.push_back(ordered(sign_ * v.cK1(), sign_ * v.cK2(), to_vec3(v.cPD1()), to_vec3(v.cPD2())));
    }
    return result;
  }

 private:
  VcgMesh mesh_;
  std::string name_;
  double sign_;  ///< +1 where the estimator's curvature is positive on a sphere
};

}  // namespace

void add_vcg_ring_peers(const TriangleMesh& mesh, PeerList& peers)
{
  peers.push_back(
      std::make_unique<VcgRings>(mesh, "vcg_taubin", vcg::tri::UpdateCurvature<VcgMesh>::PrincipalDirections, 1));
  peers.push_back(std::make_unique<VcgRings>(mesh, "vcg_normal_cycle",
                                             vcg::tri::UpdateCurvature<VcgMesh>::PrincipalDirectionsNormalCycle, 1));
  peers.push_back(std::make_unique<VcgRings>(mesh, "vcg_quadric_1ring",
                                             vcg::tri::UpdateCurvatureFitting<VcgMesh>::computeCurvature, 1));
}

}  // namespace accuracy
