// SPDX-License-Identifier: GPL-3.0-or-later
// A VCG mesh in double precision with every component that VCG's curvature estimators need.
#pragma once

#include <vector>

#include <vcg/complex/complex.h>

#include "integral_invariant/mesh/surface.h"

namespace peers {

class VcgVertex;
class VcgFace;
struct VcgTypes : vcg::UsedTypes<vcg::Use<VcgVertex>::AsVertexType, vcg::Use<VcgFace>::AsFaceType> {};
class VcgVertex
    : public vcg::Vertex<VcgTypes, vcg::vertex::Coord3d, vcg::vertex::Normal3d, vcg::vertex::CurvatureDird,
                         vcg::vertex::VFAdj, vcg::vertex::Mark, vcg::vertex::BitFlags, vcg::vertex::Qualityd> {};
class VcgFace : public vcg::Face<VcgTypes, vcg::face::VertexRef, vcg::face::Normal3d, vcg::face::FFAdj,
                                 vcg::face::VFAdj, vcg::face::Mark, vcg::face::BitFlags> {};
class VcgMesh : public vcg::tri::TriMesh<std::vector<VcgVertex>, std::vector<VcgFace>> {};

/// Fills `m` with the mesh, its adjacency, bounding box and angle-weighted unit normals.
inline void fill(VcgMesh& m, const integral_invariant::TriangleMesh& mesh)
{
  vcg::tri::Allocator<VcgMesh>::AddVertices(m, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    m.vert[v].P() = {mesh.positions[v].x, mesh.positions[v].y, mesh.positions[v].z};
  for (const integral_invariant::Triangle& t : mesh.triangles)
    vcg::tri::Allocator<VcgMesh>::AddFace(m, std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2]));
  vcg::tri::UpdateTopology<VcgMesh>::FaceFace(m);
  vcg::tri::UpdateTopology<VcgMesh>::VertexFace(m);
  vcg::tri::UpdateFlags<VcgMesh>::FaceBorderFromFF(m);
  vcg::tri::UpdateFlags<VcgMesh>::VertexBorderFromFaceBorder(m);
  vcg::tri::UpdateBounding<VcgMesh>::Box(m);
  vcg::tri::UpdateNormal<VcgMesh>::PerVertexAngleWeighted(m);
  vcg::tri::UpdateNormal<VcgMesh>::NormalizePerVertex(m);
}

inline integral_invariant::Vec3 to_vec3(const vcg::Point3d& p) { return {p[0], p[1], p[2]}; }

}  // namespace peers
