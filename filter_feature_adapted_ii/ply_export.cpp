// SPDX-License-Identifier: GPL-3.0-or-later
// PLY export through VCG. The mesh type is this file's own: the host's has no room for all outputs, and the exporter
// writes only scalars.
#include "ply_export.h"

#include <cstdio>
#include <filesystem>
#include <system_error>

#include <vcg/complex/complex.h>
#include <wrap/io_trimesh/export_ply.h>

namespace integral_invariant::filter {

namespace {

namespace fs = std::filesystem;
using Scalar = MESHLAB_SCALAR;

class ExportVertex;
class ExportEdge;
class ExportFace;
struct ExportTypes : vcg::UsedTypes<vcg::Use<ExportVertex>::AsVertexType, vcg::Use<ExportEdge>::AsEdgeType,
                                    vcg::Use<ExportFace>::AsFaceType> {};

template <class Base>
class Coordinates : public vcg::vertex::Coord<vcg::Point3<Scalar>, Base> {
};
template <class Base>
class QualityOf : public vcg::vertex::Quality<Scalar, Base> {
};

class ExportVertex
    : public vcg::Vertex<ExportTypes, Coordinates, vcg::vertex::BitFlags, QualityOf, vcg::vertex::Color4b> {};
class ExportEdge : public vcg::Edge<ExportTypes, vcg::edge::VertexRef, vcg::edge::BitFlags> {};
class ExportFace : public vcg::Face<ExportTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
class ExportMesh
    : public vcg::tri::TriMesh<std::vector<ExportVertex>, std::vector<ExportEdge>, std::vector<ExportFace>> {};

using Allocator = vcg::tri::Allocator<ExportMesh>;

void copy_mesh(const TriangleMesh& mesh, const PlyContents& contents, ExportMesh& copy)
{
  Allocator::AddVertices(copy, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    copy.vert[v].P() = {Scalar(p.x), Scalar(p.y), Scalar(p.z)};
    if (!contents.quality.empty()) copy.vert[v].Q() = Scalar(contents.quality[v]);
    if (!contents.colors.empty())
      copy.vert[v].C() = vcg::Color4b(contents.colors[v][0], contents.colors[v][1], contents.colors[v][2], 255);
  }
  Allocator::AddFaces(copy, mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for (int corner = 0; corner < 3; ++corner)
      copy.face[f].V(corner) = &copy.vert[std::size_t(mesh.triangles[f][std::size_t(corner)])];
  Allocator::AddEdges(copy, contents.edges.size());
  for (std::size_t e = 0; e < contents.edges.size(); ++e)
    for (int end = 0; end < 2; ++end)
      copy.edge[e].V(end) = &copy.vert[std::size_t(contents.edges[e][std::size_t(end)])];
}

/// Adds one float property a vertex. Its name must outlive the export: 2020.09's descriptors keep the pointer.
/// Described here rather than with PlyInfo's helper, which in 2020.09 writes into whatever PlyInfo came first.
void add_property(ExportMesh& mesh, vcg::tri::io::PlyInfo& info, const NamedValues& property)
{
  const char* name = property.name.c_str();
  auto attribute = Allocator::AddPerVertexAttribute<float>(mesh, name);
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) attribute[v] = property.values[v];
  vcg::ply::PropDescriptor descriptor = {};
  descriptor.elemname = "vertex";
  descriptor.propname = name;
  descriptor.stotype1 = descriptor.memtype1 = vcg::ply::T_FLOAT;
  info.VertDescriptorVec.push_back(descriptor);
  info.VertAttrNameVec.emplace_back(name);
}

template <class ValueOf>
NamedValues property(std::string name, std::size_t count, ValueOf value_of)
{
  NamedValues named{std::move(name), std::vector<float>(count)};
  for (std::size_t v = 0; v < count; ++v) named.values[v] = float(value_of(v));
  return named;
}

void add_direction(const std::string& name, const std::vector<Vec3>& directions, std::vector<NamedValues>& properties)
{
  const std::size_t n = directions.size();
  properties.push_back(property(name + "_x", n, [&](std::size_t v) { return directions[v].x; }));
  properties.push_back(property(name + "_y", n, [&](std::size_t v) { return directions[v].y; }));
  properties.push_back(property(name + "_z", n, [&](std::size_t v) { return directions[v].z; }));
}

PlyContents contents_of(const Outcome& outcome)
{
  const Result& result = outcome.result;
  const std::size_t n = result.kappa_max.size();
  PlyContents contents;
  contents.quality = outcome.quality;
  if (outcome.colorize)
    for (std::size_t v = 0; v < n; ++v) contents.colors.push_back(outcome.color(v));
  contents.properties = {property("ii_kmax", n, [&](std::size_t v) { return result.kappa_max[v]; }),
                         property("ii_kmin", n, [&](std::size_t v) { return result.kappa_min[v]; }),
                         property("ii_radius", n, [&](std::size_t v) { return result.radius[v]; }),
                         property("ii_confidence", n, [&](std::size_t v) { return result.confidence[v]; })};
  if (!result.standard_error.empty())
    contents.properties.push_back(property("ii_error", n, [&](std::size_t v) { return result.standard_error[v]; }));
  add_direction("ii_dirmax", result.dir_max, contents.properties);
  add_direction("ii_dirmin", result.dir_min, contents.properties);
  return contents;
}

/// VCG's exporter does not notice a full disk: a file without room for its own elements is one.
std::size_t smallest_file_size(const TriangleMesh& mesh, const PlyContents& contents)
{
  const std::size_t vertex_bytes = 3 * sizeof(Scalar) + contents.properties.size() * sizeof(float);
  constexpr std::size_t face_bytes = 1 + 3 * sizeof(int), edge_bytes = 2 * sizeof(int);
  return mesh.positions.size() * vertex_bytes + mesh.triangles.size() * face_bytes + contents.edges.size() * edge_bytes;
}

[[noreturn]] void refuse(const std::string& path, const std::string& reason)
{
  throw InputError("The file '" + path + "' (export_file) cannot be written: " + reason +
                   ". Choose a folder that exists and that you may write to. The mesh is unchanged.");
}

fs::path temporary_for(const fs::path& target) { return target.string() + ".part"; }

}  // namespace

void require_writable(const std::string& path)
{
  const fs::path target = fs::absolute(path);
  if (fs::is_directory(target)) refuse(path, "it is a folder");
  const fs::path temporary = temporary_for(target);
  std::FILE* file = std::fopen(temporary.c_str(), "wb");
  if (!file) refuse(path, std::generic_category().message(errno));
  std::fclose(file);
  std::error_code ignored;
  fs::remove(temporary, ignored);
}

std::string export_ply(const TriangleMesh& mesh, const PlyContents& contents, const std::string& path)
{
  using vcg::tri::io::Mask;
  const fs::path target = fs::absolute(path), temporary = temporary_for(target);
  ExportMesh copy;
  copy_mesh(mesh, contents, copy);
  vcg::tri::io::PlyInfo info;
  for (const NamedValues& values : contents.properties) add_property(copy, info, values);
  info.mask = (contents.quality.empty() ? 0 : Mask::IOM_VERTQUALITY) |
              (contents.colors.empty() ? 0 : Mask::IOM_VERTCOLOR) | (contents.edges.empty() ? 0 : Mask::IOM_EDGEINDEX);

  const int failed = vcg::tri::io::ExporterPLY<ExportMesh>::Save(copy, temporary.c_str(), true, info);
  std::error_code error;
  const bool complete = !failed && fs::file_size(temporary, error) >= smallest_file_size(mesh, contents) && !error;
  if (complete) fs::rename(temporary, target, error);
  if (complete && !error) return target.string();
  std::error_code ignored;
  fs::remove(temporary, ignored);
  refuse(path, error ? error.message() : "the folder or the disk does not take it");
}

std::string export_ply(const TriangleMesh& mesh, const Outcome& outcome, const std::string& path)
{
  return export_ply(mesh, contents_of(outcome), path);
}

}  // namespace integral_invariant::filter
