// SPDX-License-Identifier: GPL-3.0-or-later
// What the exporter writes, read back by a reader of the test's own.
#include "ply_export.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <unistd.h>

#include "support/shapes.h"

namespace integral_invariant::filter {
namespace {

namespace fs = std::filesystem;

/// Vertex properties by name, and the triangles, of a little-endian binary PLY.
struct PlyContent {
  std::map<std::string, std::vector<double>> properties;
  std::vector<Triangle> triangles;
};

double read_value(std::istream& in, const std::string& type)
{
  char bytes[8];
  const std::map<std::string, int> sizes{{"float", 4}, {"double", 8}, {"uchar", 1}};
  in.read(bytes, sizes.at(type));
  if (type == "uchar") return static_cast<unsigned char>(bytes[0]);
  float single;
  double value;
  std::memcpy(&single, bytes, sizeof single);
  std::memcpy(&value, bytes, sizeof value);
  return type == "float" ? single : value;
}

PlyContent read_ply(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  std::vector<std::pair<std::string, std::string>> columns;  // name, type
  std::size_t vertices = 0, faces = 0;
  for (std::string line; std::getline(in, line) && line != "end_header";) {
    std::istringstream words(line);
    std::string first, second, third;
    words >> first >> second >> third;
    if (first == "element") (second == "vertex" ? vertices : faces) = std::stoul(third);
    if (first == "property" && second != "list") columns.emplace_back(third, second);
  }
  PlyContent content;
  for (std::size_t v = 0; v < vertices; ++v)
    for (const auto& [name, type] : columns) content.properties[name].push_back(read_value(in, type));
  for (std::size_t f = 0; f < faces; ++f) {
    EXPECT_EQ(in.get(), 3);
    Triangle triangle;
    in.read(reinterpret_cast<char*>(triangle.data()), sizeof triangle);
    content.triangles.push_back(triangle);
  }
  EXPECT_TRUE(in.good());
  EXPECT_EQ(in.peek(), std::char_traits<char>::eof());
  return content;
}

/// Values that differ at every vertex and in every property.
Result made_up_result(std::size_t n)
{
  Result result;
  for (std::size_t v = 0; v < n; ++v) {
    const double x = double(v);
    result.kappa_max.push_back(x + 0.5);
    result.kappa_min.push_back(-x);
    result.radius.push_back(1 + x / 64);
    result.confidence.push_back(float(v) / float(n));
    result.dir_max.push_back({x, 2 * x, 3 * x});
    result.dir_min.push_back({-x, -2 * x, -3 * x});
  }
  return result;
}

class PlyExport : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  fs::path folder = fs::path(testing::TempDir()) / ("ply_export_test." + std::to_string(::getpid()));
  TriangleMesh mesh = test_support::icosphere(1);
  Outcome outcome = make_outcome(made_up_result(mesh.positions.size()), {});
};

TEST_F(PlyExport, HasEveryOutputOfEveryVertex)
{
  const fs::path file = folder / "out \xc3\xa9.ply";
  EXPECT_EQ(export_ply(mesh, outcome, file.string()), file.string());
  const PlyContent content = read_ply(file);
  EXPECT_EQ(content.triangles, mesh.triangles);
  const auto& p = content.properties;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_FLOAT_EQ(float(p.at("x")[v]), float(mesh.positions[v].x));
    EXPECT_EQ(p.at("ii_kmax")[v], outcome.result.kappa_max[v]);
    EXPECT_EQ(p.at("ii_kmin")[v], outcome.result.kappa_min[v]);
    EXPECT_EQ(p.at("ii_radius")[v], outcome.result.radius[v]);
    EXPECT_EQ(p.at("ii_confidence")[v], outcome.result.confidence[v]);
    EXPECT_EQ(p.at("ii_dirmax_x")[v], outcome.result.dir_max[v].x);
    EXPECT_EQ(p.at("ii_dirmax_y")[v], outcome.result.dir_max[v].y);
    EXPECT_EQ(p.at("ii_dirmin_z")[v], outcome.result.dir_min[v].z);
    EXPECT_EQ(p.at("quality")[v], outcome.quality[v]);
    EXPECT_EQ(p.at("green")[v], outcome.color(v)[1]);
  }
}

TEST_F(PlyExport, TwoExportsInOneProcessAreTheSame)
{
  export_ply(mesh, outcome, (folder / "a.ply").string());
  export_ply(mesh, outcome, (folder / "b.ply").string());
  EXPECT_EQ(fs::file_size(folder / "a.ply"), fs::file_size(folder / "b.ply"));
  EXPECT_EQ(read_ply(folder / "a.ply").properties, read_ply(folder / "b.ply").properties);
}

TEST_F(PlyExport, WithoutColoursThereAreNone)
{
  outcome.colorize = false;
  export_ply(mesh, outcome, (folder / "a.ply").string());
  EXPECT_EQ(read_ply(folder / "a.ply").properties.count("red"), 0u);
}

TEST_F(PlyExport, LeavesNoOtherFile)
{
  require_writable((folder / "a.ply").string());
  EXPECT_TRUE(fs::is_empty(folder));
  export_ply(mesh, outcome, (folder / "a.ply").string());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

TEST_F(PlyExport, SaysWhatCannotBeWritten)
{
  for (const std::string& path : {(folder / "no such folder" / "a.ply").string(), folder.string()}) {
    EXPECT_THROW(require_writable(path), InputError);
    EXPECT_THROW(export_ply(mesh, outcome, path), InputError);
  }
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace integral_invariant::filter
