// SPDX-License-Identifier: GPL-3.0-or-later
// What a host's mesh has beside its shape, for the file that a filter writes: normals, colours, texture coordinates,
// scalars and named attributes, of vertices and faces. Only read; deleted elements are skipped, as in the copy that is
// measured.
#pragma once

#include <string>
#include <typeindex>
#include <vector>

#include <vcg/complex/complex.h>

#include "ply_export.h"

namespace integral_invariant::filter {

/// The fields that every mesh of MeshLab has room for, as far as they hold something of the user's.
struct FilledFields {
  bool vertex_color = false;
  bool vertex_quality = false;
};

namespace mesh_extras_detail {

/// Pointers to the elements that are not deleted.
template <class Container>
auto present(const Container& elements)
{
  std::vector<const typename Container::value_type*> pointers;
  pointers.reserve(elements.size());
  for (const auto& element : elements)
    if (!element.IsD()) pointers.push_back(&element);
  return pointers;
}

template <class Element>
void add_colors(const std::vector<const Element*>& elements, std::vector<PlyProperty>& properties)
{
  const char* const channels[] = {"red", "green", "blue", "alpha"};
  for (int channel = 0; channel < 4; ++channel)
    properties.push_back(ply_property<std::uint8_t>(channels[channel], elements.size(),
                                                    [&](std::size_t i) { return elements[i]->cC()[channel]; }));
}

template <class Element>
void add_quality(const std::vector<const Element*>& elements, std::vector<PlyProperty>& properties)
{
  properties.push_back(
      exact_property("quality", elements.size(), [&](std::size_t i) { return double(elements[i]->cQ()); }));
}

/// The named attributes that are scalars or points of the host's scalar type; a point becomes name_x, name_y, name_z.
/// `index_of` gives an element's place among all, deleted ones included.
template <class MeshType, class Attributes, class Element, class IndexOf>
void add_attributes(const Attributes& attributes, const std::vector<const Element*>& elements, IndexOf index_of,
                    std::vector<PlyProperty>& properties)
{
  using Scalar = typename MeshType::ScalarType;
  using Point = typename MeshType::CoordType;
  const std::size_t n = elements.size();
  for (const auto& attribute : attributes) {
    const auto* data = attribute._handle;
    const auto at = [&](std::size_t i) { return data->At(index_of(*elements[i])); };
    if (attribute._name.empty()) continue;
    if (attribute._type == std::type_index(typeid(Scalar)))
      properties.push_back(exact_property(attribute._name, n,
                                          [&](std::size_t i) { return double(*static_cast<const Scalar*>(at(i))); }));
    if (attribute._type != std::type_index(typeid(Point))) continue;
    const char* const axes[] = {"_x", "_y", "_z"};
    for (int axis = 0; axis < 3; ++axis)
      properties.push_back(exact_property(attribute._name + axes[axis], n, [&](std::size_t i) {
        return double((*static_cast<const Point*>(at(i)))[axis]);
      }));
  }
}

template <class MeshType>
void add_vertex_extras(const MeshType& mesh, const FilledFields& filled, std::vector<PlyProperty>& properties)
{
  const auto vertices = present(mesh.vert);
  const std::size_t n = vertices.size();
  const char* const normal[] = {"nx", "ny", "nz"};
  for (int axis = 0; axis < 3; ++axis)
    properties.push_back(
        exact_property(normal[axis], n, [&](std::size_t v) { return double(vertices[v]->cN()[axis]); }));
  if (vcg::tri::HasPerVertexTexCoord(mesh)) {
    properties.push_back(ply_property<float>("s", n, [&](std::size_t v) { return vertices[v]->cT().U(); }));
    properties.push_back(ply_property<float>("t", n, [&](std::size_t v) { return vertices[v]->cT().V(); }));
  }
  if (filled.vertex_color) add_colors(vertices, properties);
  if (filled.vertex_quality) add_quality(vertices, properties);
  const auto index_of = [&](const typename MeshType::VertexType& v) { return vcg::tri::Index(mesh, v); };
  add_attributes<MeshType>(mesh.vert_attr, vertices, index_of, properties);
}

template <class MeshType>
void add_face_extras(const MeshType& mesh, std::vector<PlyProperty>& properties)
{
  const auto faces = present(mesh.face);
  const std::size_t n = faces.size();
  if (vcg::tri::HasPerWedgeTexCoord(mesh)) {
    properties.push_back(ply_list<float, 6>("texcoord", n, [&](std::size_t f) {
      std::array<float, 6> list{};
      for (std::size_t corner = 0; corner < 3; ++corner) {
        list[2 * corner] = float(faces[f]->cWT(int(corner)).U());
        list[2 * corner + 1] = float(faces[f]->cWT(int(corner)).V());
      }
      return list;
    }));
    properties.push_back(
        ply_property<std::int32_t>("texnumber", n, [&](std::size_t f) { return faces[f]->cWT(0).N(); }));
  }
  if (vcg::tri::HasPerFaceColor(mesh)) add_colors(faces, properties);
  if (vcg::tri::HasPerFaceQuality(mesh)) add_quality(faces, properties);
  const auto index_of = [&](const typename MeshType::FaceType& f) { return vcg::tri::Index(mesh, f); };
  add_attributes<MeshType>(mesh.face_attr, faces, index_of, properties);
}

}  // namespace mesh_extras_detail

template <class MeshType>
MeshExtras mesh_extras(const MeshType& mesh, const FilledFields& filled)
{
  MeshExtras extras;
  mesh_extras_detail::add_vertex_extras(mesh, filled, extras.vertex);
  mesh_extras_detail::add_face_extras(mesh, extras.face);
  for (const std::string& texture : mesh.textures) extras.comments.push_back("TextureFile " + texture);
  return extras;
}

}  // namespace integral_invariant::filter
