// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygonise.h"

#include <stdexcept>

#include <vcg/complex/complex.h>
#include <vcg/complex/algorithms/clean.h>
#include <vcg/complex/algorithms/create/marching_cubes.h>
#include <vcg/complex/algorithms/create/mc_trivial_walker.h>
#include <vcg/complex/algorithms/isotropic_remeshing.h>
#include <wrap/io_trimesh/export_ply.h>

namespace samples {
namespace {

class Vertex;
class Edge;
class Face;
struct Types : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Edge>::AsEdgeType, vcg::Use<Face>::AsFaceType> {
};
class Vertex
    : public vcg::Vertex<Types, vcg::vertex::Coord3f, vcg::vertex::Normal3f, vcg::vertex::VFAdj, vcg::vertex::Qualityf,
                         vcg::vertex::Color4b, vcg::vertex::BitFlags, vcg::vertex::Mark> {};
class Edge : public vcg::Edge<Types> {};
class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::Normal3f, vcg::face::FFAdj, vcg::face::VFAdj,
                              vcg::face::Qualityf, vcg::face::BitFlags, vcg::face::Mark> {};
class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>> {};

using Volume = vcg::SimpleVolume<vcg::SimpleVoxel<float>>;
using Walker = vcg::tri::TrivialWalker<Mesh, Volume>;

void sample_on_grid(const FusedShapes& solid, double cell, Volume& volume)
{
  const double half = solid.extent() + 3 * cell;
  const int cells = int(std::ceil(2 * half / cell));
  const float bound = float(cells * cell / 2);
  volume.Init({cells, cells, cells}, {{-bound, -bound, -bound}, {bound, bound, bound}});
  for (int z = 0; z < cells; ++z)
    for (int y = 0; y < cells; ++y)
      for (int x = 0; x < cells; ++x) {
        vcg::Point3f p{float(x), float(y), float(z)};
        volume.IPfToPf(p, p);
        volume.V(x, y, z).V() = float(solid({p[0], p[1], p[2]}));
      }
}

void extract_surface(Volume& volume, Mesh& mesh)
{
  Walker walker;
  vcg::tri::MarchingCubes<Mesh, Walker> marching_cubes(mesh, walker);
  walker.BuildMesh(mesh, volume, marching_cubes, 0);
}

void project(const FusedShapes& solid, Mesh& mesh)
{
  for (Vertex& v : mesh.vert) {
    const Point p = solid.projected({v.P()[0], v.P()[1], v.P()[2]});
    v.P() = vcg::Point3f(float(p[0]), float(p[1]), float(p[2]));
  }
}

/// Marching cubes leaves slivers, which any measure of curvature would feel.
void make_triangles_even(const FusedShapes& solid, double edge, Mesh& mesh)
{
  constexpr int rounds = 6;
  vcg::tri::IsotropicRemeshing<Mesh>::Params params;
  params.SetTargetLen(float(edge));
  params.SetFeatureAngleDeg(180);    // the solid is smooth: what looks like a crease is the grid's
  params.maxSurfDist = float(edge);  // read even where it is not checked
  params.surfDistCheck = false;
  params.projectFlag = false;  // the solid itself is a better guide than its first mesh
  for (int round = 0; round < rounds; ++round) {
    vcg::tri::IsotropicRemeshing<Mesh>::Do(mesh, params);
    vcg::tri::Allocator<Mesh>::CompactEveryVector(mesh);
    project(solid, mesh);
  }
}

void orient_outward_and_check(Mesh& mesh)
{
  using Clean = vcg::tri::Clean<Mesh>;
  vcg::tri::UpdateTopology<Mesh>::FaceFace(mesh);
  int edges = 0, non_manifold = 0, boundary = 0;
  Clean::CountEdgeNum(mesh, edges, boundary, non_manifold);
  if (mesh.fn == 0 || boundary + non_manifold > 0) throw std::runtime_error("the polygonised surface is not closed");
  bool oriented = false, orientable = false;
  Clean::OrientCoherentlyMesh(mesh, oriented, orientable);
  if (!orientable) throw std::runtime_error("the polygonised surface cannot be oriented");
  if (vcg::tri::Stat<Mesh>::ComputeMeshVolume(mesh) < 0) Clean::FlipMesh(mesh);
  if (Clean::CountConnectedComponents(mesh) != 1) throw std::runtime_error("the polygonised surface is in pieces");
}

}  // namespace

MeshSize polygonise(const FusedShapes& solid, double edge, const std::string& ply_file)
{
  Mesh mesh;
  {
    Volume volume;
    sample_on_grid(solid, edge, volume);
    extract_surface(volume, mesh);
  }
  make_triangles_even(solid, edge, mesh);
  orient_outward_and_check(mesh);
  const int error = vcg::tri::io::ExporterPLY<Mesh>::Save(mesh, ply_file.c_str(), true);
  if (error != 0)
    throw std::runtime_error("cannot write " + ply_file + ": " + vcg::tri::io::ExporterPLY<Mesh>::ErrorMsg(error));
  return {std::size_t(mesh.vn), std::size_t(mesh.fn)};
}

}  // namespace samples
