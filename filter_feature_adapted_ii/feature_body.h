// SPDX-License-Identifier: GPL-3.0-or-later
// What the filters for features do, over any mesh type with MeshLab's fields and for either plugin interface:
// everything is computed and exported before a mesh is touched.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "feature_outcome.h"
#include "filter_body.h"
#include "ply_export.h"

namespace integral_invariant::filter {

/// Writes what the outcome holds to the file: the lines, or the mesh with quality, colour and attributes.
inline std::string export_feature(const TriangleMesh& mesh, const FeatureOutcome& outcome, const std::string& file)
{
  if (!outcome.lines)
    return export_ply(mesh, PlyContents{{}, outcome.quality, outcome.colors, outcome.attributes}, file);
  const LineLayer& lines = *outcome.lines;
  return export_ply({lines.positions, {}}, PlyContents{lines.edges, lines.quality, lines.colors, lines.attributes},
                    file);
}

/// Runs the filter on `mesh`, which is only read, and writes the export file, if any.
/// \throw std::exception with a sentence for the user
template <class MeshType>
FeatureOutcome measure_feature(FilterId filter, const MeshType& mesh, const Request& request,
                               const ProgressCallback& progress)
{
  const std::string& file = request.output.export_file;
  if (!file.empty()) require_writable(file);
  const TriangleMesh copy = vcg::tri::UpdateCurvatureIntegralInvariant<MeshType>::CopyMesh(mesh);
  FeatureOutcome outcome = compute_feature(filter, copy, request, progress);
  if (file.empty()) return outcome;
  outcome.exported = export_feature(copy, outcome, file);
  outcome.log.push_back("Exported: " + outcome.exported);
  return outcome;
}

/// The values as named attributes of the vertices, in the host's scalar type: others are not listed by later releases.
/// All of them, or none where memory runs out.
template <class MeshType>
void write_attributes(MeshType& mesh, const std::vector<NamedValues>& attributes)
{
  using Scalar = typename MeshType::ScalarType;
  using Transaction = vcg::tri::VertexAttributeTransaction<MeshType>;
  Transaction transaction(mesh, attributes.size());
  std::vector<typename Transaction::template Handle<Scalar>> handles;
  handles.reserve(attributes.size());
  for (const NamedValues& attribute : attributes)
    handles.push_back(transaction.template Attribute<Scalar>(attribute.name));
  transaction.Commit();
  vcg::tri::UpdateCurvatureIntegralInvariant<MeshType>::ForEachVertexWithIndex(
      mesh, [&](typename MeshType::VertexType& vertex, std::size_t v) {
        for (std::size_t i = 0; i < handles.size(); ++i) handles[i][vertex] = Scalar(attributes[i].values[v]);
      });
}

/// Selects the vertices of the regions, and the faces that lie inside one.
/// `of_slot` has one entry a vertex, deleted ones included, all -1.
template <class MeshType>
void write_selection(MeshType& mesh, const std::vector<std::int32_t>& region, std::vector<std::int32_t> of_slot)
{
  vcg::tri::UpdateCurvatureIntegralInvariant<MeshType>::ForEachVertexWithIndex(
      mesh, [&](typename MeshType::VertexType& vertex, std::size_t v) {
        of_slot[vcg::tri::Index(mesh, vertex)] = region[v];
        if (region[v] >= 0)
          vertex.SetS();
        else
          vertex.ClearS();
      });
  for (auto& face : mesh.face) {
    if (face.IsD()) continue;
    const std::int32_t first = of_slot[vcg::tri::Index(mesh, face.cV(0))];
    const bool inside = first >= 0 && of_slot[vcg::tri::Index(mesh, face.cV(1))] == first &&
                        of_slot[vcg::tri::Index(mesh, face.cV(2))] == first;
    if (inside)
      face.SetS();
    else
      face.ClearS();
  }
}

/// Writes selection, quality, colour and attributes: all, or nothing where memory runs out. The host has enabled the
/// fields.
template <class MeshType>
void write_feature(MeshType& mesh, const FeatureOutcome& outcome)
{
  using Update = vcg::tri::UpdateCurvatureIntegralInvariant<MeshType>;
  using Vertex = typename MeshType::VertexType;
  std::vector<std::int32_t> of_slot(outcome.selection.empty() ? 0 : mesh.vert.size(), -1);
  write_attributes(mesh, outcome.attributes);  // the last that can fail
  if (!outcome.selection.empty()) write_selection(mesh, outcome.selection, std::move(of_slot));
  Update::ForEachVertexWithIndex(mesh, [&](Vertex& vertex, std::size_t v) {
    if (!outcome.quality.empty())
      vertex.Q() = Update::template Representable<typename Vertex::QualityType>(outcome.quality[v]);
    if (outcome.colors.empty()) return;
    const Color color = outcome.colors[v];
    vertex.C() = vcg::Color4b(color[0], color[1], color[2], 255);
  });
}

/// Fills the empty mesh of a new layer with vertices and edges. The host has enabled quality and colour.
template <class MeshType>
void fill_with_lines(MeshType& mesh, const LineLayer& lines)
{
  using Allocator = vcg::tri::Allocator<MeshType>;
  using Scalar = typename MeshType::ScalarType;
  const auto point = [](const Vec3& p) { return typename MeshType::CoordType(Scalar(p.x), Scalar(p.y), Scalar(p.z)); };
  Allocator::AddVertices(mesh, lines.positions.size());
  for (std::size_t v = 0; v < lines.positions.size(); ++v) {
    auto& vertex = mesh.vert[v];
    vertex.P() = point(lines.positions[v]);
    vertex.N() = point(lines.normals[v]);
    vertex.Q() = typename MeshType::VertexType::QualityType(lines.quality[v]);
    if (lines.colors.empty()) continue;
    const Color& color = lines.colors[v];
    vertex.C() = vcg::Color4b(color[0], color[1], color[2], 255);
  }
  Allocator::AddEdges(mesh, lines.edges.size());
  for (std::size_t e = 0; e < lines.edges.size(); ++e)
    for (int end = 0; end < 2; ++end) mesh.edge[e].V(end) = &mesh.vert[std::size_t(lines.edges[e][std::size_t(end)])];
  write_attributes(mesh, lines.attributes);
  vcg::tri::UpdateBounding<MeshType>::Box(mesh);
}

}  // namespace integral_invariant::filter
