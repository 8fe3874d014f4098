// SPDX-License-Identifier: GPL-3.0-or-later
// UpdateCurvatureFitting::updateCurvatureLocal, run only at the judged vertices.
#include "peers/vcg_mesh.h"

#include <vcg/complex/algorithms/update/curvature_fitting.h>

#include "peers/peer.h"

namespace accuracy {

using namespace peers;

namespace {

class VcgQuadric : public Peer {
 public:
  explicit VcgQuadric(const TriangleMesh& mesh) { fill(mesh_, mesh); }
  std::string name() const override { return "vcg_quadric"; }
  bool takes_radius() const override { return true; }
  std::vector<Estimate> estimate(const std::vector<std::uint32_t>& vertices, const std::vector<Vec3>&,
                                 double radius) override
  {
    std::vector<Estimate> result;
    for (const std::uint32_t v : vertices) result.push_back(fit(mesh_.vert[v], float(radius)));
    return result;
  }

 private:
  using Fitting = vcg::tri::UpdateCurvatureFitting<VcgMesh>;

  Estimate fit(VcgVertex& v, float radius)
  {
    std::vector<VcgVertex*> near, facing;
    Fitting::expandSphereLocal(mesh_, &v, radius, 5, &near);
    vcg::Point3d normal;
    Fitting::getAverageNormal(&v, near, &normal);
    Fitting::applyProjOnPlane(normal, near, &facing);
    if (facing.size() >= 5) near = facing;
    std::vector<vcg::Point3d> frame;
    Fitting::computeReferenceFramesLocal(&v, normal, &frame);
    Fitting::QuadricLocal quadric(0, 0, 0, 0, 0);
    Fitting::fitQuadricLocal(&v, frame, near, &quadric);
    const vcg::Point3d own_normal = v.N();  // finalEigenStuff overwrites the normal, which other vertices still need
    Fitting::finalEigenStuff(&v, frame, quadric);
    v.N() = own_normal;
    return ordered(v.K1(), v.K2(), to_vec3(v.PD1()), to_vec3(v.PD2()));
  }

  VcgMesh mesh_;
};

}  // namespace

void add_vcg_quadric_peer(const TriangleMesh& mesh, PeerList& peers)
{
  peers.push_back(std::make_unique<VcgQuadric>(mesh));
}

}  // namespace accuracy
