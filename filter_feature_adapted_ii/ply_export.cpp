// SPDX-License-Identifier: GPL-3.0-or-later
// Results and mesh as the elements of a PLY file.
#include "ply_export.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "integral_invariant/error.h"
#include "ply_writer.h"
#include "whole_file.h"

namespace integral_invariant::filter {

namespace {

/// In single precision, which a curvature in very small units leaves.
float storable(double value)
{
  constexpr double largest = std::numeric_limits<float>::max();
  return float(std::clamp(value, -largest, largest));
}

template <class ValueOf>
NamedValues property(std::string name, std::size_t count, ValueOf value_of)
{
  NamedValues named{std::move(name), std::vector<float>(count)};
  for (std::size_t v = 0; v < count; ++v) named.values[v] = storable(value_of(v));
  return named;
}

void add_direction(const std::string& name, const std::vector<Vec3>& directions, std::vector<NamedValues>& properties)
{
  const std::size_t n = directions.size();
  properties.push_back(property(name + "_x", n, [&](std::size_t v) { return directions[v].x; }));
  properties.push_back(property(name + "_y", n, [&](std::size_t v) { return directions[v].y; }));
  properties.push_back(property(name + "_z", n, [&](std::size_t v) { return directions[v].z; }));
}

void add_curvature(const Result& result, std::vector<NamedValues>& properties)
{
  const std::size_t n = result.kappa_max.size();
  properties.push_back(property("ii_kmax", n, [&](std::size_t v) { return result.kappa_max[v]; }));
  properties.push_back(property("ii_kmin", n, [&](std::size_t v) { return result.kappa_min[v]; }));
  properties.push_back(property("ii_radius", n, [&](std::size_t v) { return result.radius[v]; }));
  properties.push_back(property("ii_confidence", n, [&](std::size_t v) { return result.confidence[v]; }));
  if (!result.standard_error.empty())
    properties.push_back(property("ii_error", n, [&](std::size_t v) { return result.standard_error[v]; }));
  add_direction("ii_dirmax", result.dir_max, properties);
  add_direction("ii_dirmin", result.dir_min, properties);
}

/// A coordinate of every vertex.
PlyProperty coordinate(const char* name, const std::vector<Vec3>& positions, double Vec3::*axis)
{
  return exact_property(name, positions.size(), [&](std::size_t v) { return positions[v].*axis; });
}

bool is_component(const std::string& name)
{
  const std::string end = name.size() < 2 ? "" : name.substr(name.size() - 2);
  return end == "_x" || end == "_y" || end == "_z";
}

/// Scalars are there a second time as scalar_<name>, by which CloudCompare knows them; it reads no others unasked.
std::vector<PlyProperty> result_properties(const PlyContents& contents, std::size_t vertices)
{
  std::vector<PlyProperty> properties;
  const char* const channels[] = {"red", "green", "blue"};
  for (std::size_t channel = 0; channel < 3 && !contents.colors.empty(); ++channel)
    properties.push_back(ply_property<std::uint8_t>(channels[channel], vertices,
                                                    [&](std::size_t v) { return contents.colors[v][channel]; }));
  if (!contents.colors.empty())
    properties.push_back(ply_property<std::uint8_t>("alpha", vertices, [](std::size_t) { return 255; }));
  const auto add = [&](const std::string& name, auto value_of) {
    properties.push_back(ply_property<float>(name, vertices, value_of));
  };
  if (!contents.quality.empty()) add("quality", [&](std::size_t v) { return storable(contents.quality[v]); });
  for (const NamedValues& named : contents.properties) add(named.name, [&](std::size_t v) { return named.values[v]; });
  for (const NamedValues& named : contents.properties)
    if (!is_component(named.name)) add("scalar_" + named.name, [&](std::size_t v) { return named.values[v]; });
  return properties;
}

bool has(const std::vector<PlyProperty>& properties, const std::string& name)
{
  return std::any_of(properties.begin(), properties.end(), [&](const PlyProperty& p) { return p.name == name; });
}

bool is_measured(const PlyProperty& property) { return property.name.rfind("ii_", 0) == 0; }

/// What the user brought follows under its name, or where a result has that name, as original_<name>. Beside results of
/// an earlier run, what they have the names of is theirs too, and makes room for this one's.
void add_extras(std::vector<PlyProperty> extras, std::vector<PlyProperty>& properties)
{
  const bool measured_before = std::any_of(extras.begin(), extras.end(), is_measured);
  std::vector<PlyProperty> kept;
  for (PlyProperty& extra : extras) {
    const bool replaced = has(properties, extra.name);
    if (replaced && measured_before) continue;
    if (replaced) extra.name = "original_" + extra.name;
    kept.push_back(std::move(extra));
  }
  properties.insert(properties.end(), std::make_move_iterator(kept.begin()), std::make_move_iterator(kept.end()));
}

PlyElement vertex_element(const TriangleMesh& mesh, const PlyContents& contents)
{
  PlyElement vertices{"vertex", mesh.positions.size(), result_properties(contents, mesh.positions.size())};
  add_extras(contents.extras.vertex, vertices.properties);
  vertices.properties.insert(vertices.properties.begin(),
                             {coordinate("x", mesh.positions, &Vec3::x), coordinate("y", mesh.positions, &Vec3::y),
                              coordinate("z", mesh.positions, &Vec3::z)});
  return vertices;
}

PlyElement face_element(const TriangleMesh& mesh, const MeshExtras& extras)
{
  const std::size_t n = mesh.triangles.size();
  PlyElement faces{
      "face", n, {ply_list<std::int32_t, 3>("vertex_indices", n, [&](std::size_t f) { return mesh.triangles[f]; })}};
  add_extras(extras.face, faces.properties);
  return faces;
}

PlyElement edge_element(const PlyContents& contents)
{
  const auto& edges = contents.edges;
  return {"edge",
          edges.size(),
          {ply_property<std::int32_t>("vertex1", edges.size(), [&](std::size_t e) { return edges[e][0]; }),
           ply_property<std::int32_t>("vertex2", edges.size(), [&](std::size_t e) { return edges[e][1]; })}};
}

[[noreturn]] void refuse(const std::string& path, const FileError& error)
{
  throw InputError("The file '" + path + "' (export_file) cannot be written: " + error.what() +
                   " The mesh is unchanged.");
}

}  // namespace

void require_writable(const std::string& path)
{
  try {
    WholeFile never_committed(path);
  } catch (const FileError& error) {
    refuse(path, error);
  }
}

std::string export_bytes(const std::string& bytes, const std::string& path)
{
  try {
    WholeFile file(path);
    file.write(bytes.data(), bytes.size());
    return file.commit();
  } catch (const FileError& error) {
    refuse(path, error);
  }
}

std::string export_ply(const TriangleMesh& mesh, const PlyContents& contents, const std::string& path)
{
  std::vector<PlyElement> elements{vertex_element(mesh, contents), face_element(mesh, contents.extras)};
  if (!contents.edges.empty()) elements.push_back(edge_element(contents));
  try {
    return write_ply(elements, contents.extras.comments, path);
  } catch (const FileError& error) {
    refuse(path, error);
  }
}

std::string export_ply(const TriangleMesh& mesh, const FilterResult& result, const std::string& path,
                       const MeshExtras& extras)
{
  if (result.lines) {
    const LineLayer& lines = *result.lines;
    return export_ply({lines.positions, {}},
                      PlyContents{lines.edges, lines.quality, lines.colors, lines.attributes, {}}, path);
  }
  PlyContents contents{{}, result.quality, result.colors, {}, extras};
  if (result.curvature) add_curvature(*result.curvature, contents.properties);
  contents.properties.insert(contents.properties.end(), result.attributes.begin(), result.attributes.end());
  return export_ply(mesh, contents, path);
}

}  // namespace integral_invariant::filter
