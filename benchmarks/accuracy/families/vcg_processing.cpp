// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/vcg_processing.h"

#include <map>
#include <vector>

#include <vcg/complex/complex.h>

#include <vcg/complex/algorithms/clean.h>
#include <vcg/complex/algorithms/create/marching_cubes.h>
#include <vcg/complex/algorithms/isotropic_remeshing.h>
#include <vcg/complex/algorithms/local_optimization.h>
#include <vcg/complex/algorithms/local_optimization/tri_edge_collapse_quadric.h>

#include "families/volume.h"

namespace accuracy {

using integral_invariant::Triangle;

namespace {

class Vertex;
class Face;
struct Types : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Face>::AsFaceType> {};
class Vertex : public vcg::Vertex<Types, vcg::vertex::Coord3d, vcg::vertex::Normal3d, vcg::vertex::VFAdj,
                                  vcg::vertex::Mark, vcg::vertex::BitFlags, vcg::vertex::Qualityd> {
 public:
  vcg::math::Quadric<double>& Qd() { return quadric_; }

 private:
  vcg::math::Quadric<double> quadric_;
};
class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::Normal3d, vcg::face::FFAdj, vcg::face::VFAdj,
                              vcg::face::Mark, vcg::face::Qualityd, vcg::face::BitFlags> {};
class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>> {};

using Pair = vcg::tri::BasicVertexPair<Vertex>;
class Collapse : public vcg::tri::TriEdgeCollapseQuadric<Mesh, Pair, Collapse, vcg::tri::QInfoStandard<Vertex>> {
 public:
  using Base = vcg::tri::TriEdgeCollapseQuadric<Mesh, Pair, Collapse, vcg::tri::QInfoStandard<Vertex>>;
  Collapse(const Pair& pair, int mark, vcg::BaseParameterClass* parameters) : Base(pair, mark, parameters) {}
};

void fill(Mesh& m, const TriangleMesh& mesh)
{
  vcg::tri::Allocator<Mesh>::AddVertices(m, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    m.vert[v].P() = {mesh.positions[v].x, mesh.positions[v].y, mesh.positions[v].z};
  for (const Triangle& t : mesh.triangles)
    vcg::tri::Allocator<Mesh>::AddFace(m, std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2]));
  vcg::tri::UpdateBounding<Mesh>::Box(m);
}

TriangleMesh taken(Mesh& m)
{
  vcg::tri::Clean<Mesh>::RemoveUnreferencedVertex(m);
  vcg::tri::Allocator<Mesh>::CompactEveryVector(m);
  TriangleMesh mesh;
  for (const Vertex& v : m.vert) mesh.positions.push_back({v.cP()[0], v.cP()[1], v.cP()[2]});
  for (const Face& f : m.face)
    mesh.triangles.push_back(
        {int(vcg::tri::Index(m, f.cV(0))), int(vcg::tri::Index(m, f.cV(1))), int(vcg::tri::Index(m, f.cV(2)))});
  return mesh;
}

/// Feeds the cells of a volume to VCG's marching cubes; cells share the vertices on their common edges.
class Walker {
 public:
  Walker(const Volume& volume, Mesh& mesh) : volume_(volume), mesh_(mesh) {}

  void march()
  {
    vcg::tri::MarchingCubes<Mesh, Walker> cubes(mesh_, *this);
    cubes.Initialize();
    for (int z = 0; z + 1 < volume_.size[2]; ++z)
      for (int y = 0; y + 1 < volume_.size[1]; ++y)
        for (int x = 0; x + 1 < volume_.size[0]; ++x) cubes.ProcessCell({x, y, z}, {x + 1, y + 1, z + 1});
    cubes.Finalize();
  }
  float V(int x, int y, int z) const { return float(volume_.at(x, y, z)); }
  bool Exist(const vcg::Point3i& a, const vcg::Point3i& b, Vertex*& v)
  {
    const auto it = vertices_.find({a, b});
    v = it == vertices_.end() ? nullptr : &mesh_.vert[it->second];
    return v != nullptr;
  }
  void GetXIntercept(const vcg::Point3i& a, const vcg::Point3i& b, Vertex*& v) { intercept(a, b, v); }
  void GetYIntercept(const vcg::Point3i& a, const vcg::Point3i& b, Vertex*& v) { intercept(a, b, v); }
  void GetZIntercept(const vcg::Point3i& a, const vcg::Point3i& b, Vertex*& v) { intercept(a, b, v); }

 private:
  void intercept(const vcg::Point3i& a, const vcg::Point3i& b, Vertex*& v)
  {
    if (Exist(a, b, v)) return;
    vertices_[{a, b}] = mesh_.vert.size();
    const double at_a = volume_.at(a[0], a[1], a[2]), at_b = volume_.at(b[0], b[1], b[2]), t = at_a / (at_a - at_b);
    const Vec3 p = volume_.place(a[0], a[1], a[2]), q = volume_.place(b[0], b[1], b[2]), between = p + (q - p) * t;
    v = &*vcg::tri::Allocator<Mesh>::AddVertex(mesh_, Mesh::CoordType(between.x, between.y, between.z));
  }

  const Volume& volume_;
  Mesh& mesh_;
  std::map<std::pair<vcg::Point3i, vcg::Point3i>, std::size_t> vertices_;
};

/// The value of the nearest voxel.
double nearest_value(const Volume& volume, const Vec3& p)
{
  const Vec3 off = p - volume.origin;
  const auto along = [](double distance, double step, int size) {
    return std::clamp(int(std::lround(distance / step)), 0, size - 1);
  };
  return volume.at(along(off.x, volume.spacing.x, volume.size[0]), along(off.y, volume.spacing.y, volume.size[1]),
                   along(off.z, volume.spacing.z, volume.size[2]));
}

/// Whether most triangles face smaller values.
bool faces_inward(const TriangleMesh& mesh, const Volume& volume)
{
  const double step = std::max({volume.spacing.x, volume.spacing.y, volume.spacing.z});
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[std::size_t(t[0])], &b = mesh.positions[std::size_t(t[1])],
               &c = mesh.positions[std::size_t(t[2])];
    const Vec3 n = normalized(cross(b - a, c - a)) * step;
    sum += nearest_value(volume, a + n) - nearest_value(volume, a - n);
  }
  return sum < 0;
}

}  // namespace

TriangleMesh decimated(const TriangleMesh& mesh, int vertices)
{
  Mesh m;
  fill(m, mesh);
  vcg::tri::UpdateTopology<Mesh>::VertexFace(m);
  vcg::tri::TriEdgeCollapseQuadricParameter parameters;
  parameters.QualityThr = 0.3;  // MeshLab's default
  vcg::LocalOptimization<Mesh> session(m, &parameters);
  session.Init<Collapse>();
  session.SetTargetVertices(vertices);
  session.SetTimeBudget(60);
  while (session.DoOptimization() && m.vn > vertices) {}
  session.Finalize<Collapse>();
  return taken(m);
}

TriangleMesh isotropically_remeshed(const TriangleMesh& mesh, double edge)
{
  constexpr int iterations = 3;
  Mesh m, original;
  fill(m, mesh);
  fill(original, mesh);
  vcg::tri::UpdateNormal<Mesh>::PerFaceNormalized(original);
  vcg::tri::UpdateTopology<Mesh>::FaceFace(m);
  typename vcg::tri::IsotropicRemeshing<Mesh>::Params parameters;
  parameters.SetTargetLen(edge);
  parameters.SetFeatureAngleDeg(180);  // so that noise is not taken for creases
  parameters.maxSurfDist = edge;
  parameters.iter = iterations;
  vcg::tri::IsotropicRemeshing<Mesh>::Do(m, original, parameters);
  return taken(m);
}

TriangleMesh marching_cubes(const Volume& volume)
{
  Mesh m;
  Walker(volume, m).march();
  TriangleMesh mesh = taken(m);
  if (faces_inward(mesh, volume))
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace accuracy
