// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/vcg_mesh.h"

#include <vcg/complex/algorithms/update/curvature.h>

#include "peers/peer.h"

namespace accuracy {

using namespace peers;

namespace {

/// With MeshLab's parameters except the radius. It can only process the whole mesh.
class VcgPca : public Peer {
 public:
  explicit VcgPca(const TriangleMesh& mesh) { fill(mesh_, mesh); }
  std::string name() const override { return "vcg_pca"; }
  bool takes_radius() const override { return true; }
  std::vector<Estimate> estimate(const std::vector<std::uint32_t>& vertices, const std::vector<Vec3>&,
                                 double radius) override
  {
    vcg::tri::UpdateCurvature<VcgMesh>::PrincipalDirectionsPCA(mesh_, radius, true);
    std::vector<Estimate> result;
    for (const std::uint32_t i : vertices) {
      const VcgVertex& v = mesh_.vert[i];
      result.push_back(ordered(v.cK1(), v.cK2(), to_vec3(v.cPD1()), to_vec3(v.cPD2())));
    }
    return result;
  }

 private:
  VcgMesh mesh_;
};

}  // namespace

void add_vcg_pca_peer(const TriangleMesh& mesh, PeerList& peers) { peers.push_back(std::make_unique<VcgPca>(mesh)); }

}  // namespace accuracy
