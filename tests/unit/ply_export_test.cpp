// SPDX-License-Identifier: GPL-3.0-or-later
// What the exporter writes, read back by a reader of the tests' own; and that no file is ever short.
#include "ply_export.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "curvature_result.h"
#include "integral_invariant/error.h"
#include "support/full_disk.h"
#include "support/ply_file.h"
#include "support/program.h"
#include "support/shapes.h"

namespace integral_invariant::filter {
namespace {

namespace fs = std::filesystem;

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
  test_support::TemporaryFolder temporary;
  fs::path folder = temporary.path();
  TriangleMesh mesh = test_support::icosphere(1);
  FilterResult result = curvature_result(made_up_result(mesh.positions.size()), {});
};

TEST_F(PlyExport, HasEveryOutputOfEveryVertex)
{
  const fs::path file = folder / "out \xc3\xa9.ply";
  EXPECT_EQ(export_ply(mesh, result, file.string()), file.string());
  const test_support::PlyFile content = test_support::read_ply(file.string());
  EXPECT_EQ(content.triangles, mesh.triangles);
  const auto& p = content.vertex;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_FLOAT_EQ(float(p.at("x")[v]), float(mesh.positions[v].x));
    EXPECT_EQ(p.at("ii_kmax")[v], result.curvature->kappa_max[v]);
    EXPECT_EQ(p.at("scalar_ii_kmax")[v], result.curvature->kappa_max[v]);
    EXPECT_EQ(p.at("ii_kmin")[v], result.curvature->kappa_min[v]);
    EXPECT_EQ(p.at("ii_radius")[v], result.curvature->radius[v]);
    EXPECT_EQ(p.at("ii_confidence")[v], result.curvature->confidence[v]);
    EXPECT_EQ(p.at("ii_dirmax_x")[v], result.curvature->dir_max[v].x);
    EXPECT_EQ(p.at("ii_dirmax_y")[v], result.curvature->dir_max[v].y);
    EXPECT_EQ(p.at("ii_dirmin_z")[v], result.curvature->dir_min[v].z);
    EXPECT_EQ(p.at("quality")[v], result.quality[v]);
    EXPECT_EQ(p.at("green")[v], result.colors[v][1]);
  }
}

TEST_F(PlyExport, KeepsCoordinatesOfDoublePrecision)
{
  for (Vec3& p : mesh.positions) p = p + Vec3{5e5, 5e6, 100};
  export_ply(mesh, result, (folder / "a.ply").string());
  const test_support::PlyFile content = test_support::read_ply(folder / "a.ply");
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_EQ(content.property("x")[v], mesh.positions[v].x);
    EXPECT_EQ(content.property("y")[v], mesh.positions[v].y);
    EXPECT_EQ(content.property("z")[v], mesh.positions[v].z);
  }
}

TEST_F(PlyExport, HoldsWhatIsBeyondSinglePrecisionAsItsLargestValue)
{
  result.curvature->kappa_max[3] = 1e60;
  result.quality[4] = -1e60;
  export_ply(mesh, result, (folder / "a.ply").string());
  const test_support::PlyFile content = test_support::read_ply(folder / "a.ply");
  EXPECT_EQ(content.property("ii_kmax")[3], std::numeric_limits<float>::max());
  EXPECT_EQ(content.property("quality")[4], -std::numeric_limits<float>::max());
}

/// What a host's mesh brings: a colour, a scalar and texture coordinates.
MeshExtras made_up_extras(const TriangleMesh& mesh)
{
  const auto row = [](std::size_t i) { return double(i); };
  MeshExtras extras;
  extras.vertex = {ply_property<std::uint8_t>("red", mesh.positions.size(), [](std::size_t v) { return v % 200; }),
                   exact_property("temperature", mesh.positions.size(), row),
                   exact_property("precise", mesh.positions.size(), [](std::size_t v) { return double(v) / 10; })};
  extras.face = {ply_list<float, 6>("texcoord", mesh.triangles.size(),
                                    [](std::size_t f) { return std::array<float, 6>{float(f), 1, 2, 3, 4, 5}; }),
                 exact_property("stress tensor", mesh.triangles.size(), row)};
  extras.comments = {"TextureFile skin.png"};
  return extras;
}

TEST_F(PlyExport, KeepsWhatTheUserBroughtBesideTheResults)
{
  PlyContents contents;
  contents.colors.assign(mesh.positions.size(), Color{1, 2, 3});
  contents.extras = made_up_extras(mesh);
  const fs::path file = folder / "a.ply";
  export_ply(mesh, contents, file.string());
  const test_support::PlyFile content = test_support::read_ply(file);
  EXPECT_EQ(content.triangles, mesh.triangles);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_EQ(content.property("red")[v], 1);
    EXPECT_EQ(content.property("original_red")[v], double(v % 200));
    EXPECT_EQ(content.property("temperature")[v], double(v));
    EXPECT_EQ(content.property("precise")[v], double(v) / 10) << "in double precision, where single would change it";
  }
  const std::string text = test_support::read_text(file);
  const std::string header = text.substr(0, text.find("end_header"));
  for (const char* line :
       {"comment TextureFile skin.png\n", "property list uchar float texcoord\n", "property float stress_tensor\n",
        "property float temperature\n", "property double precise\n"})
    EXPECT_NE(header.find(line), std::string::npos) << line;
}

TEST_F(PlyExport, ResultsOfAnEarlierRunMakeRoom)
{
  PlyContents contents;
  contents.colors.assign(mesh.positions.size(), Color{1, 2, 3});
  contents.extras = made_up_extras(mesh);
  contents.extras.vertex.push_back(exact_property("ii_kmax", mesh.positions.size(), [](std::size_t) { return 9; }));
  contents.properties = {{"ii_kmax", std::vector<float>(mesh.positions.size(), 4)}};
  export_ply(mesh, contents, (folder / "a.ply").string());
  const test_support::PlyFile content = test_support::read_ply(folder / "a.ply");
  EXPECT_EQ(content.property("ii_kmax")[0], 4);
  EXPECT_EQ(content.property("red")[0], 1);
  EXPECT_EQ(content.property("temperature")[5], 5);
  EXPECT_EQ(content.vertex.count("original_red") + content.vertex.count("original_ii_kmax"), 0u);
}

TEST_F(PlyExport, WithoutColoursThereAreNone)
{
  result.colors.clear();
  export_ply(mesh, result, (folder / "a.ply").string());
  EXPECT_EQ(test_support::read_ply(folder / "a.ply").vertex.count("red"), 0u);
}

TEST_F(PlyExport, LeavesNoOtherFile)
{
  require_writable((folder / "a.ply").string());
  EXPECT_TRUE(fs::is_empty(folder));
  export_ply(mesh, result, (folder / "a.ply").string());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

TEST_F(PlyExport, SaysWhatCannotBeWritten)
{
  for (const std::string& path : {(folder / "no such folder" / "a.ply").string(), folder.string()}) {
    EXPECT_THROW(require_writable(path), InputError);
    EXPECT_THROW(export_ply(mesh, result, path), InputError);
  }
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(PlyExport, FollowsALinkAndKeepsThePermissionsOfTheFile)
{
  constexpr fs::perms mine = fs::perms::owner_read | fs::perms::owner_write;
  test_support::write_text(folder / "data.ply", "older");
  fs::permissions(folder / "data.ply", mine);
  fs::create_symlink("data.ply", folder / "link.ply");
  EXPECT_EQ(export_ply(mesh, result, (folder / "link.ply").string()), (folder / "data.ply").string());
  EXPECT_TRUE(fs::is_symlink(folder / "link.ply"));
  EXPECT_EQ(fs::status(folder / "data.ply").permissions(), mine);
  EXPECT_EQ(test_support::read_ply(folder / "link.ply").triangles, mesh.triangles);
}

TEST_F(PlyExport, ReplacesNoDevice)
{
  EXPECT_THROW(export_ply(mesh, result, "/dev/null"), InputError);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

/// On a disk of any size, a file of 190 kB is whole, or the refusal names the lack of room and an older file is as it
/// was.
class FullDisk : public PlyExport {
 protected:
  void SetUp() override
  {
    mesh = test_support::icosphere(4);
    result = curvature_result(made_up_result(mesh.positions.size()), {});
    export_ply(mesh, result, (folder / "whole.ply").string());
    whole = test_support::read_text(folder / "whole.ply");
    fs::create_directory(folder / "disk");
  }

  /// \return whether the file was written
  bool whole_file_or_refusal(std::size_t room)
  {
    const fs::path file = folder / "disk" / "out.ply";
    const bool there = fs::exists(file);
    std::string refusal;
    try {
      export_ply(mesh, result, file.string());
    } catch (const InputError& error) {
      refusal = error.what();
    }
    EXPECT_TRUE(refusal.empty() || refusal.find("Make room there") != std::string::npos) << refusal;
    EXPECT_EQ(fs::exists(file), refusal.empty() || there) << room;
    const std::string expected = refusal.empty() ? whole : there ? "older" : "";
    EXPECT_EQ(fs::exists(file) ? test_support::read_text(file) : "", expected) << room;
    EXPECT_LE(std::distance(fs::directory_iterator(folder / "disk"), {}), 1) << room;
    return refusal.empty();
  }

  std::string whole;
  static constexpr std::size_t first = 8192, step = 4096;
};

TEST_F(FullDisk, LeavesNoShortFileWhereFilesCannotGrow)
{
  test_support::write_text(folder / "disk" / "out.ply", "older");
  for (std::size_t room = first; room < whole.size(); room += step) {
    const test_support::SmallFiles limit(room);
    EXPECT_FALSE(whole_file_or_refusal(room));
  }
  const test_support::SmallFiles limit(whole.size());
  EXPECT_TRUE(whole_file_or_refusal(whole.size()));
}

TEST_F(FullDisk, LeavesNoShortFileOnADiskOfAnySize)
{
  bool written = false;
  for (std::size_t room = first; room < whole.size() + 3 * step; room += step) {
    const test_support::SmallDisk disk(folder / "disk", room);
    if (!disk.unavailable().empty()) GTEST_SKIP() << "only root can do this: " << disk.unavailable();
    if (room > whole.size() / 2) test_support::write_text(folder / "disk" / "out.ply", "older");
    written = whole_file_or_refusal(room);
    EXPECT_TRUE(!written || room >= whole.size()) << room;
  }
  EXPECT_TRUE(written) << "the last disk has room";
}

}  // namespace
}  // namespace integral_invariant::filter
