// SPDX-License-Identifier: GPL-3.0-or-later
// Results and mesh as the elements of a PLY file.
#include "ply_export.h"

#include <algorithm>
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

bool fit_single_precision(const std::vector<Vec3>& positions)
{
  const auto fits = [](double x) { return double(float(x)) == x; };
  return std::all_of(positions.begin(), positions.end(),
                     [&](const Vec3& p) { return fits(p.x) && fits(p.y) && fits(p.z); });
}

template <class Scalar>
void add_coordinates(const std::vector<Vec3>& positions, PlyElement& vertices)
{
  const std::size_t n = positions.size();
  vertices.properties.push_back(ply_property<Scalar>("x", n, [&](std::size_t v) { return positions[v].x; }));
  vertices.properties.push_back(ply_property<Scalar>("y", n, [&](std::size_t v) { return positions[v].y; }));
  vertices.properties.push_back(ply_property<Scalar>("z", n, [&](std::size_t v) { return positions[v].z; }));
}

void add_colors(const std::vector<Color>& colors, PlyElement& vertices)
{
  const char* const channels[] = {"red", "green", "blue"};
  for (std::size_t channel = 0; channel < 3; ++channel)
    vertices.properties.push_back(ply_property<std::uint8_t>(channels[channel], colors.size(),
                                                             [&](std::size_t v) { return colors[v][channel]; }));
  vertices.properties.push_back(ply_property<std::uint8_t>("alpha", colors.size(), [](std::size_t) { return 255; }));
}

/// Coordinates in single precision where that changes none of them.
PlyElement vertex_element(const TriangleMesh& mesh, const PlyContents& contents)
{
  const std::size_t n = mesh.positions.size();
  PlyElement vertices{"vertex", n, {}};
  if (fit_single_precision(mesh.positions))
    add_coordinates<float>(mesh.positions, vertices);
  else
    add_coordinates<double>(mesh.positions, vertices);
  if (!contents.colors.empty()) add_colors(contents.colors, vertices);
  const auto add = [&](const std::string& name, auto value_of) {
    vertices.properties.push_back(ply_property<float>(name, n, value_of));
  };
  if (!contents.quality.empty()) add("quality", [&](std::size_t v) { return storable(contents.quality[v]); });
  for (const NamedValues& named : contents.properties) add(named.name, [&](std::size_t v) { return named.values[v]; });
  return vertices;
}

PlyElement face_element(const TriangleMesh& mesh)
{
  const std::size_t n = mesh.triangles.size();
  return {
      "face", n, {ply_list<std::int32_t, 3>("vertex_indices", n, [&](std::size_t f) { return mesh.triangles[f]; })}};
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

std::string export_ply(const TriangleMesh& mesh, const PlyContents& contents, const std::string& path)
{
  std::vector<PlyElement> elements{vertex_element(mesh, contents), face_element(mesh)};
  if (!contents.edges.empty()) elements.push_back(edge_element(contents));
  try {
    return write_ply(elements, {}, path);
  } catch (const FileError& error) {
    refuse(path, error);
  }
}

std::string export_ply(const TriangleMesh& mesh, const FilterResult& result, const std::string& path)
{
  if (result.lines) {
    const LineLayer& lines = *result.lines;
    return export_ply({lines.positions, {}}, PlyContents{lines.edges, lines.quality, lines.colors, lines.attributes},
                      path);
  }
  PlyContents contents{{}, result.quality, result.colors, {}};
  if (result.curvature) add_curvature(*result.curvature, contents.properties);
  contents.properties.insert(contents.properties.end(), result.attributes.begin(), result.attributes.end());
  return export_ply(mesh, contents, path);
}

}  // namespace integral_invariant::filter
