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
class ExportFace;
struct ExportTypes : vcg::UsedTypes<vcg::Use<ExportVertex>::AsVertexType, vcg::Use<ExportFace>::AsFaceType> {};

template <class Base>
class Coordinates : public vcg::vertex::Coord<vcg::Point3<Scalar>, Base> {};
template <class Base>
class QualityOf : public vcg::vertex::Quality<Scalar, Base> {};

class ExportVertex
    : public vcg::Vertex<ExportTypes, Coordinates, vcg::vertex::BitFlags, QualityOf, vcg::vertex::Color4b> {};
class ExportFace : public vcg::Face<ExportTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
class ExportMesh : public vcg::tri::TriMesh<std::vector<ExportVertex>, std::vector<ExportFace>> {};

using Allocator = vcg::tri::Allocator<ExportMesh>;

void copy_mesh(const TriangleMesh& mesh, const Outcome& outcome, ExportMesh& copy)
{
  Allocator::AddVertices(copy, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    const Color color = outcome.color(v);
    copy.vert[v].P() = {Scalar(p.x), Scalar(p.y), Scalar(p.z)};
    copy.vert[v].Q() = Scalar(outcome.quality[v]);
    copy.vert[v].C() = vcg::Color4b(color[0], color[1], color[2], 255);
  }
  Allocator::AddFaces(copy, mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for (int corner = 0; corner < 3; ++corner)
      copy.face[f].V(corner) = &copy.vert[std::size_t(mesh.triangles[f][std::size_t(corner)])];
}

/// Adds one float property a vertex. `name` must outlive the export: 2020.09's descriptors keep the pointer.
/// Described here rather than with PlyInfo's helper, which in 2020.09 writes into whatever PlyInfo came first.
template <class ValueOf>
void add_property(ExportMesh& mesh, vcg::tri::io::PlyInfo& info, const char* name, ValueOf value_of)
{
  auto attribute = Allocator::AddPerVertexAttribute<float>(mesh, name);
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) attribute[v] = float(value_of(v));
  vcg::ply::PropDescriptor descriptor = {};
  descriptor.elemname = "vertex";
  descriptor.propname = name;
  descriptor.stotype1 = descriptor.memtype1 = vcg::ply::T_FLOAT;
  info.VertDescriptorVec.push_back(descriptor);
  info.VertAttrNameVec.emplace_back(name);
}

void add_direction(ExportMesh& mesh, vcg::tri::io::PlyInfo& info, const std::array<const char*, 3>& names,
                   const std::vector<Vec3>& directions)
{
  add_property(mesh, info, names[0], [&](std::size_t v) { return directions[v].x; });
  add_property(mesh, info, names[1], [&](std::size_t v) { return directions[v].y; });
  add_property(mesh, info, names[2], [&](std::size_t v) { return directions[v].z; });
}

void add_properties(ExportMesh& mesh, vcg::tri::io::PlyInfo& info, const Result& result)
{
  add_property(mesh, info, "ii_kmax", [&](std::size_t v) { return result.kappa_max[v]; });
  add_property(mesh, info, "ii_kmin", [&](std::size_t v) { return result.kappa_min[v]; });
  add_property(mesh, info, "ii_radius", [&](std::size_t v) { return result.radius[v]; });
  if (!result.standard_error.empty())
    add_property(mesh, info, "ii_error", [&](std::size_t v) { return result.standard_error[v]; });
  add_property(mesh, info, "ii_confidence", [&](std::size_t v) { return result.confidence[v]; });
  add_direction(mesh, info, {"ii_dirmax_x", "ii_dirmax_y", "ii_dirmax_z"}, result.dir_max);
  add_direction(mesh, info, {"ii_dirmin_x", "ii_dirmin_y", "ii_dirmin_z"}, result.dir_min);
}

/// VCG's exporter does not notice a full disk: a file without room for its own elements is one.
std::size_t smallest_file_size(const TriangleMesh& mesh)
{
  constexpr std::size_t vertex_bytes = 3 * sizeof(Scalar) + sizeof(Scalar) + 10 * sizeof(float);
  constexpr std::size_t face_bytes = 1 + 3 * sizeof(int);
  return mesh.positions.size() * vertex_bytes + mesh.triangles.size() * face_bytes;
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

std::string export_ply(const TriangleMesh& mesh, const Outcome& outcome, const std::string& path)
{
  using vcg::tri::io::Mask;
  const fs::path target = fs::absolute(path), temporary = temporary_for(target);
  ExportMesh copy;
  copy_mesh(mesh, outcome, copy);
  vcg::tri::io::PlyInfo info;
  add_properties(copy, info, outcome.result);
  info.mask = Mask::IOM_VERTQUALITY | (outcome.colorize ? Mask::IOM_VERTCOLOR : 0);

  const int failed = vcg::tri::io::ExporterPLY<ExportMesh>::Save(copy, temporary.c_str(), true, info);
  std::error_code error;
  const bool complete = !failed && fs::file_size(temporary, error) >= smallest_file_size(mesh) && !error;
  if (complete) fs::rename(temporary, target, error);
  if (complete && !error) return target.string();
  std::error_code ignored;
  fs::remove(temporary, ignored);
  refuse(path, error ? error.message() : "the folder or the disk does not take it");
}

}  // namespace integral_invariant::filter
