// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg/complex/complex.h>
#include <vcg/complex/algorithms/update/curvature_fitting.h>

#include <cmath>
#include <vector>

#include "peers/peers.h"

namespace peers {

namespace {

class VcgVertex;
class VcgFace;
struct VcgTypes : vcg::UsedTypes<vcg::Use<VcgVertex>::AsVertexType, vcg::Use<VcgFace>::AsFaceType> {};
class VcgVertex : public vcg::Vertex<VcgTypes, vcg::vertex::Coord3d, vcg::vertex::Normal3d, vcg::vertex::CurvatureDird,
                                     vcg::vertex::VFAdj, vcg::vertex::Mark, vcg::vertex::BitFlags, vcg::vertex::Qualityd> {
};
class VcgFace : public vcg::Face<VcgTypes, vcg::face::VertexRef, vcg::face::Normal3d, vcg::face::FFAdj, vcg::face::VFAdj,
                                 vcg::face::Mark, vcg::face::BitFlags> {};
class VcgMesh : public vcg::tri::TriMesh<std::vector<VcgVertex>, std::vector<VcgFace>> {};
using Fitting = vcg::tri::UpdateCurvatureFitting<VcgMesh>;

/// With what the fits ask for: adjacency, bounding box, unit normals.
void fill(VcgMesh& m, const integral_invariant::TriangleMesh& mesh)
{
  vcg::tri::Allocator<VcgMesh>::AddVertices(m, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    m.vert[v].P() = {mesh.positions[v].x, mesh.positions[v].y, mesh.positions[v].z};
  for (const integral_invariant::Triangle& t : mesh.triangles)
    vcg::tri::Allocator<VcgMesh>::AddFace(m, std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2]));
  vcg::tri::UpdateTopology<VcgMesh>::FaceFace(m);
  vcg::tri::UpdateTopology<VcgMesh>::VertexFace(m);
  vcg::tri::UpdateBounding<VcgMesh>::Box(m);
  vcg::tri::UpdateNormal<VcgMesh>::PerVertexAngleWeighted(m);
  vcg::tri::UpdateNormal<VcgMesh>::NormalizePerVertex(m);
}

double mean_curvature(const VcgMesh& m)
{
  double sum = 0;
  for (const VcgVertex& v : m.vert) sum += std::fabs(v.cK1());
  return sum / double(m.vert.size());
}

}  // namespace

double vcg_quadric(const integral_invariant::TriangleMesh& mesh)
{
  VcgMesh m;
  fill(m, mesh);
  Fitting::computeCurvature(m);
  return mean_curvature(m);
}

double vcg_scale_dependent_quadric(const integral_invariant::TriangleMesh& mesh, double radius)
{
  VcgMesh m;
  fill(m, mesh);
  Fitting::updateCurvatureLocal(m, float(radius));
  return mean_curvature(m);
}

}  // namespace peers
