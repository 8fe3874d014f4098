// SPDX-License-Identifier: GPL-3.0-or-later
#include "cad_models.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace accuracy {

using namespace integral_invariant;

namespace {

constexpr std::size_t judged_vertices = 800;

/// Layout of a fixed-size vertex record.
struct Layout {
  std::size_t vertices = 0, faces = 0, size = 0;
  std::map<std::string, std::size_t> offset;
};

Layout read_header(std::istream& in)
{
  Layout layout;
  std::string line, element;
  while (std::getline(in, line) && line.rfind("end_header", 0) != 0) {
    std::istringstream words(line);
    std::string keyword, type, name;
    words >> keyword >> type >> name;
    if (keyword == "format" && type != "binary_little_endian") throw std::runtime_error("not a binary PLY");
    if (keyword == "element") {
      element = type;
      (element == "vertex" ? layout.vertices : layout.faces) = std::stoul(name);
    }
    if (keyword != "property" || element != "vertex") continue;
    layout.offset[name] = layout.size;
    layout.size += type == "uchar" ? 1 : type == "double" ? 8 : 4;
    if (type == "double") throw std::runtime_error("double properties are not read");
  }
  return layout;
}

class Record {
 public:
  Record(const Layout& layout, const char* bytes) : layout_(layout), bytes_(bytes) {}
  double real(const std::string& name) const
  {
    float value;
    std::memcpy(&value, bytes_ + layout_.offset.at(name), sizeof value);
    return double(value);
  }
  int byte(const std::string& name) const { return std::uint8_t(bytes_[layout_.offset.at(name)]); }
  Vec3 vector(const std::string& prefix) const { return {real(prefix + "x"), real(prefix + "y"), real(prefix + "z")}; }

 private:
  const Layout& layout_;
  const char* bytes_;
};

void read_vertices(std::istream& in, const Layout& layout, TruthMesh& truth, std::vector<std::uint32_t>& known)
{
  std::vector<char> bytes(layout.size);
  double squares = 0;
  std::size_t measured = 0;
  for (std::uint32_t v = 0; v < layout.vertices; ++v) {
    in.read(bytes.data(), std::streamsize(bytes.size()));
    const Record record(layout, bytes.data());
    truth.mesh.positions.push_back(record.vector(""));
    truth.normal.push_back(normalized(record.vector("n"), {}));
    truth.kappa_max.push_back(record.real("k1"));
    truth.kappa_min.push_back(record.real("k2"));
    truth.dir_max.push_back(record.vector("d1"));
    const int ring = record.byte("ring");
    if (ring >= 3) known.push_back(v);
    if (ring == 0) continue;
    squares += truth.kappa_max[v] * truth.kappa_max[v] + truth.kappa_min[v] * truth.kappa_min[v];
    ++measured;
  }
  truth.reference.assign(layout.vertices, std::sqrt(squares / (2 * double(measured))));
}

}  // namespace

std::vector<std::string> cad_model_names()
{
  return {"cad_ball",     "cad_block_fillet",  "cad_linkrods_12k", "cad_linkrods_3k", "cad_mat_open",
          "cad_pump_nut", "cad_pump_topcover", "cgal_poly2x2y2",   "goursat_010000",  "torus_010000"};
}

TruthMesh load_cad_model(const std::string& folder, const std::string& name)
{
  std::ifstream in(folder + '/' + name + ".ply", std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + folder + '/' + name + ".ply");
  const Layout layout = read_header(in);
  TruthMesh truth;
  std::vector<std::uint32_t> known;
  read_vertices(in, layout, truth, known);
  for (std::size_t f = 0; f < layout.faces; ++f) {
    Triangle t;
    if (in.get() != 3 || !in.read(reinterpret_cast<char*>(t.data()), sizeof t))
      throw std::runtime_error(name + ": faces must be triangles");
    truth.mesh.triangles.push_back(t);
  }
  draw_judged(truth, known, judged_vertices);
  return truth;
}

}  // namespace accuracy
