// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/ply_file.h"

#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace test_support {

namespace {

struct Property {
  std::string name, type, count_type;  // count_type is empty unless it is a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  bool ascii = false;
  std::vector<Element> elements;
};

Header read_header(std::istream& in, const std::string& path)
{
  Header header;
  std::string line, word;
  std::getline(in, line);
  if (line.substr(0, 3) != "ply") throw std::runtime_error(path + " is not a PLY file");
  while (std::getline(in, line)) {
    std::istringstream words(line);
    words >> word;
    if (word == "end_header") return header;
    if (word == "format") {
      words >> word;
      if (word == "binary_big_endian") throw std::runtime_error(path + " is big endian");
      header.ascii = word == "ascii";
    } else if (word == "element") {
      header.elements.emplace_back();
      words >> header.elements.back().name >> header.elements.back().count;
    } else if (word == "property" && !header.elements.empty()) {
      Property property;
      words >> property.type;
      if (property.type == "list") words >> property.count_type >> property.type;
      words >> property.name;
      header.elements.back().properties.push_back(property);
    }
  }
  throw std::runtime_error(path + ": the header has no end");
}

template <class Type>
double read_binary(std::istream& in)
{
  Type value{};
  in.read(reinterpret_cast<char*>(&value), sizeof value);
  return double(value);
}

double read_value(std::istream& in, const std::string& type, bool ascii)
{
  double value = 0;
  if (ascii)
    in >> value;
  else if (type == "float" || type == "float32")
    value = read_binary<float>(in);
  else if (type == "double" || type == "float64")
    value = read_binary<double>(in);
  else if (type == "int" || type == "int32")
    value = read_binary<std::int32_t>(in);
  else if (type == "uint" || type == "uint32")
    value = read_binary<std::uint32_t>(in);
  else if (type == "short" || type == "int16")
    value = read_binary<std::int16_t>(in);
  else if (type == "ushort" || type == "uint16")
    value = read_binary<std::uint16_t>(in);
  else if (type == "char" || type == "int8")
    value = read_binary<std::int8_t>(in);
  else if (type == "uchar" || type == "uint8")
    value = read_binary<std::uint8_t>(in);
  else
    throw std::runtime_error("unknown PLY type " + type);
  if (!in) throw std::runtime_error("the PLY file ends too early");
  return value;
}

void add_fan(const std::vector<std::int32_t>& corners, std::vector<Triangle>& triangles)
{
  for (std::size_t i = 2; i < corners.size(); ++i) triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

void read_row(std::istream& in, const Element& element, bool ascii, PlyFile& file)
{
  for (const Property& property : element.properties) {
    if (property.count_type.empty()) {
      const double value = read_value(in, property.type, ascii);
      if (element.name == "vertex") file.vertex[property.name].push_back(value);
      if (element.name == "edge" && property.name == "vertex1") file.edges.push_back({std::int32_t(value), 0});
      if (element.name == "edge" && property.name == "vertex2") file.edges.back()[1] = std::int32_t(value);
      continue;
    }
    std::vector<std::int32_t> values(std::size_t(read_value(in, property.count_type, ascii)));
    for (std::int32_t& value : values) value = std::int32_t(read_value(in, property.type, ascii));
    if (element.name == "face" && property.name.rfind("vertex_ind", 0) == 0) add_fan(values, file.triangles);
  }
}

void write_header(std::ostream& out, const TriangleMesh& mesh, const std::map<std::string, std::vector<double>>& extra)
{
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.positions.size()
      << "\nproperty float x\nproperty float y\nproperty float z\n";
  for (const auto& [name, values] : extra) out << "property float " << name << '\n';
  out << "element face " << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
}

void write_float(std::ostream& out, double value)
{
  const float single = float(value);
  out.write(reinterpret_cast<const char*>(&single), sizeof single);
}

}  // namespace

const std::vector<double>& PlyFile::property(const std::string& name) const
{
  const auto found = vertex.find(name);
  if (found != vertex.end()) return found->second;
  std::string names;
  for (const auto& [other, values] : vertex) names += " " + other;
  throw std::runtime_error("no vertex property " + name + "; there are:" + names);
}

std::vector<Vec3> PlyFile::vectors(const std::string& name) const
{
  const auto &x = property(name + "_x"), &y = property(name + "_y"), &z = property(name + "_z");
  std::vector<Vec3> result(x.size());
  for (std::size_t v = 0; v < x.size(); ++v) result[v] = {x[v], y[v], z[v]};
  return result;
}

TriangleMesh PlyFile::mesh() const
{
  TriangleMesh mesh{{}, triangles};
  if (vertex.empty()) return mesh;
  const auto &x = property("x"), &y = property("y"), &z = property("z");
  for (std::size_t v = 0; v < x.size(); ++v) mesh.positions.push_back({x[v], y[v], z[v]});
  return mesh;
}

PlyFile read_ply(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path);
  const Header header = read_header(in, path);
  PlyFile file;
  for (const Element& element : header.elements)
    for (std::size_t row = 0; row < element.count; ++row) read_row(in, element, header.ascii, file);
  return file;
}

void write_ply(const std::string& path, const TriangleMesh& mesh,
               const std::map<std::string, std::vector<double>>& extra)
{
  std::ofstream out(path, std::ios::binary);
  write_header(out, mesh, extra);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    for (double value : {p.x, p.y, p.z}) write_float(out, value);
    for (const auto& [name, values] : extra) write_float(out, values[v]);
  }
  for (const Triangle& triangle : mesh.triangles) {
    out.put(3);
    out.write(reinterpret_cast<const char*>(triangle.data()), sizeof triangle);
  }
  if (!out.flush()) throw std::runtime_error("cannot write " + path);
}

TriangleMesh in_single_precision(TriangleMesh mesh)
{
  for (Vec3& p : mesh.positions) p = {float(p.x), float(p.y), float(p.z)};
  return mesh;
}

}  // namespace test_support
