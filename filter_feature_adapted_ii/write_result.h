// SPDX-License-Identifier: GPL-3.0-or-later
// How the result of a filter gets into a mesh, over any mesh type with MeshLab's fields and for either plugin
// interface.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/algorithms/update/curvature_integral_invariant.h>

#include "filter_result.h"

namespace integral_invariant::filter {

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

/// Writes everything but the lines: all of it, or nothing where memory runs out. The host has enabled the fields.
/// \pre the result has no attributes of its own beside curvatures: each writes its own, all or none
template <class MeshType>
void write_result(MeshType& mesh, const FilterResult& result)
{
  using Update = vcg::tri::UpdateCurvatureIntegralInvariant<MeshType>;
  using Vertex = typename MeshType::VertexType;
  std::vector<std::int32_t> of_slot(result.selection.empty() ? 0 : mesh.vert.size(), -1);
  if (result.curvature) Update::Write(mesh, *result.curvature);
  write_attributes(mesh, result.attributes);  // the last that can fail
  if (!result.selection.empty()) write_selection(mesh, result.selection, std::move(of_slot));
  Update::ForEachVertexWithIndex(mesh, [&](Vertex& vertex, std::size_t v) {
    if (!result.quality.empty())
      vertex.Q() = Update::template Representable<typename Vertex::QualityType>(result.quality[v]);
    if (result.colors.empty()) return;
    const Color color = result.colors[v];
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
