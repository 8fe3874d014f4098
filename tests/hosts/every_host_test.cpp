// SPDX-License-Identifier: GPL-3.0-or-later
// One mesh on every MeshLab release that is supported: the same bits, and the core's; plugins of another release
// refused.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "hosts/host.h"
#include "support/shapes.h"
#include "support/shuffle.h"
#include "support/single_precision.h"

namespace test_support {
namespace {

namespace fs = std::filesystem;

TriangleMesh mesh_to_measure() { return with_normal_noise(torus(1, 0.4, 60, 30), 0.005); }

class EveryHost : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override
  {
    if (!host_.unavailable.empty()) GTEST_SKIP() << host_.unavailable;
    write_ply(folder_ / "mesh.ply", mesh_to_measure());
  }

  std::string exporting(Assignments assignments = {}) const
  {
    assignments.push_back("export_file=" + (folder_ / "export.ply"));
    return filter_script(assignments);
  }

  const Host host_ = find_host(GetParam());
  const TemporaryFolder folder_;
};

TEST_P(EveryHost, ExportsWhatTheCoreComputes)
{
  const Assignments parameters = {"scales=5", "alpha=0.8", "r_max=0.3"};
  const HostRun run = run_script(host_, folder_ / "mesh.ply", exporting(parameters), folder_ / "saved.ply");
  ASSERT_EQ(run.status, 0) << run.log;
  expect_equal_to_core(read_ply(folder_ / "export.ply"), mesh_to_measure(), parameters);
}

TEST_P(EveryHost, FillsQualityRadiusAndColour)
{
  const HostRun run = run_script(host_, folder_ / "mesh.ply", exporting({"quality=3"}), folder_ / "saved.ply");
  ASSERT_EQ(run.status, 0) << run.log;
  const PlyFile saved = read_ply(folder_ / "saved.ply"), exported = read_ply(folder_ / "export.ply");
  EXPECT_EQ(saved.property("quality"), exported.property("ii_kmin"));
  EXPECT_EQ(saved.property("radius"), exported.property("ii_radius"));
  for (const char* channel : {"red", "green", "blue"}) EXPECT_EQ(saved.property(channel), exported.property(channel));
}

TEST_P(EveryHost, RefusesBadInputWithASentenceAndSavesNothing)
{
  const HostRun run =
      run_script(host_, folder_ / "mesh.ply", with_value(exporting(), "scales", "0"), folder_ / "saved.ply");
  EXPECT_NE(run.status, 0);
  EXPECT_TRUE(run.status < 128 || run.status == 255) << "ended by a signal: " << run.status;
  EXPECT_NE(run.log.find("'scales'"), std::string::npos) << run.log;
  EXPECT_FALSE(fs::exists(folder_ / "saved.ply"));
  EXPECT_FALSE(fs::exists(folder_ / "export.ply"));
}

TEST_P(EveryHost, GivesASoupTheCurvaturesOfTheWeldedMeshAtEveryCopy)
{
  const TriangleMesh mesh = in_single_precision(mesh_to_measure());
  const Soup apart = soup(mesh);
  write_ply(folder_ / "soup.ply", apart.mesh);
  ASSERT_EQ(run_script(host_, folder_ / "mesh.ply", exporting(), "").status, 0);
  const PlyFile welded = read_ply(folder_ / "export.ply");
  const HostRun run = run_script(host_, folder_ / "soup.ply", exporting(), "");
  ASSERT_EQ(run.status, 0) << run.log;
  const PlyFile found = read_ply(folder_ / "export.ply");
  for (const char* name : {"ii_kmax", "ii_kmin", "ii_radius", "ii_error", "ii_confidence", "ii_dirmax_x"})
    EXPECT_EQ(found.property(name), apart.copies(welded.property(name))) << name;
  const std::string joined = std::to_string(apart.mesh.positions.size() - mesh.positions.size());
  EXPECT_NE(run.log.find(joined + " vertices joined with another at the same place"), std::string::npos) << run.log;
}

TEST_P(EveryHost, DrawsTheSameLinesOnASoup)
{
  const auto lines_of = [&](const TriangleMesh& mesh) {
    write_ply(folder_ / "drawn.ply", mesh);
    const std::string script =
        filter_script({"export_file=" + (folder_ / "lines.ply")}, integral_invariant::filter::crest_lines_filter());
    EXPECT_EQ(run_script(host_, folder_ / "drawn.ply", script, "").status, 0);
    return read_text(folder_ / "lines.ply");
  };
  TriangleMesh ellipsoid = icosphere(3);
  for (Vec3& p : ellipsoid.positions) p = {3 * p.x, 2 * p.y, p.z};
  const std::string lines = lines_of(ellipsoid);
  EXPECT_GT(lines.size(), 1000u);
  EXPECT_TRUE(lines == lines_of(soup(ellipsoid).mesh));
}

TEST_P(EveryHost, SaysThatCoordinatesHaveLostTheShape)
{
  write_ply(folder_ / "far.ply", translated(torus(3, 1, 90, 30), {5e5, 5e6, 100}));
  const HostRun run = run_script(host_, folder_ / "far.ply", exporting(), folder_ / "saved.ply");
  EXPECT_NE(run.status, 0);
  EXPECT_NE(run.log.find("have lost its shape"), std::string::npos) << run.log;
  EXPECT_NE(run.log.find("Move the mesh to the origin"), std::string::npos) << run.log;
  EXPECT_FALSE(fs::exists(folder_ / "export.ply"));
}

/// What MeshLab reads of a PLY file; the rest it has not seen.
TEST_P(EveryHost, KeepsWhatTheMeshHadBeside)
{
  const TriangleMesh mesh = mesh_to_measure();
  std::map<std::string, std::vector<double>> beside;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double row = double(v) / 8, odd = double(v % 2);
    for (const auto& [name, value] : {std::pair("quality", row), std::pair("s", row), std::pair("t", -row),
                                      std::pair("nx", odd), std::pair("ny", 1 - odd), std::pair("nz", 0.0)})
      beside[name].push_back(value);
  }
  write_ply(folder_ / "rich.ply", mesh, beside);
  const HostRun run = run_script(host_, folder_ / "rich.ply", exporting({"quality=2"}), "");
  ASSERT_EQ(run.status, 0) << run.log;
  const PlyFile found = read_ply(folder_ / "export.ply");
  for (const auto& [name, values] : beside)
    EXPECT_EQ(found.property(name == "quality" ? "original_quality" : name), values) << name;
  EXPECT_EQ(found.property("quality"), found.property("ii_kmax"));
}

std::string name_of(const testing::TestParamInfo<const char*>& info)
{
  std::string name = std::string("MeshLab_") + info.param;
  name[name.find('.')] = '_';
  return name;
}
INSTANTIATE_TEST_SUITE_P(Releases, EveryHost, testing::Values("2020.09", "2022.02", "2025.07"), name_of);

/// All but the normals, which each host computes for itself where the file has none.
TEST(AllHosts, WriteTheSameBytes)
{
  const TemporaryFolder folder;
  write_ply(folder / "mesh.ply", mesh_to_measure());
  const std::vector<const char*> ours{"x",           "y",           "z",           "red",          "green",
                                      "blue",        "alpha",       "quality",     "ii_kmax",      "ii_kmin",
                                      "ii_radius",   "ii_error",    "ii_dirmax_x", "ii_dirmax_y",  "ii_dirmax_z",
                                      "ii_dirmin_x", "ii_dirmin_y", "ii_dirmin_z", "ii_confidence"};
  std::vector<std::vector<double>> first;
  int compared = 0;
  for (const char* release : {"2020.09", "2022.02", "2025.07"}) {
    const Host host = find_host(release);
    if (!host.unavailable.empty()) continue;
    const std::string file = folder / (std::string(release) + ".ply");
    const HostRun run = run_script(host, folder / "mesh.ply", filter_script({"export_file=" + file}), "");
    ASSERT_EQ(run.status, 0) << run.log;
    const PlyFile found = read_ply(file);
    std::vector<std::vector<double>> values;
    for (const char* name : ours) values.push_back(found.property(name));
    if (first.empty()) first = values;
    EXPECT_EQ(values, first) << release;
    ++compared;
  }
  if (compared < 2) GTEST_SKIP() << "not run: fewer than two hosts are here";
}

/// The release that is asked to load a plugin, and the one that the plugin was built for.
using WrongPair = std::pair<const char*, const char*>;

class WrongHost : public testing::TestWithParam<WrongPair> {};

TEST_P(WrongHost, RefusesThePluginAndGoesOn)
{
  const auto [release, other] = GetParam();
  const Host host = find_host(release);
  const std::string plugin =
      other == std::string("double")
          ? build_folder() + "/hosts/2025.07-double/filter_feature_adapted_ii/libfilter_feature_adapted_ii.so"
          : find_host(other).plugin;
  if (!host.unavailable.empty()) GTEST_SKIP() << host.unavailable;
  if (!fs::exists(plugin)) GTEST_SKIP() << "not run: there is no " << plugin;

  const ProgramResult run = run_program(runner_command(release, {"--plugin", plugin, "--list-filters"}));
  EXPECT_EQ(run.status, 3) << run.output;
  EXPECT_NE(run.output.find("the plugin was not loaded"), std::string::npos) << run.output;
}
INSTANTIATE_TEST_SUITE_P(Pairs, WrongHost,
                         testing::Values(WrongPair{"2022.02", "2020.09"}, WrongPair{"2022.02", "2025.07"},
                                         WrongPair{"2025.07", "2020.09"}, WrongPair{"2025.07", "2022.02"},
                                         WrongPair{"2025.07", "double"}));

TEST(WrongHostOf2020, LeavesThePluginOutAndGoesOn)
{
  const Host host = find_host("2020.09"), later = find_host("2025.07");
  if (!host.unavailable.empty()) GTEST_SKIP() << host.unavailable;
  if (!later.unavailable.empty()) GTEST_SKIP() << later.unavailable;
  const TemporaryFolder folder;
  const std::string make =
      "set -euo pipefail; source \"$0/lib/all.sh\"; "
      "MESHLAB_2020_09=$1 II_BUILD=${2%/$PLUGIN}; make_meshlab_2020_09";
  ASSERT_EQ(run_program({"bash", "-c", make, source_folder() + "/scripts", folder / "prefix", later.plugin}).status, 0);
  write_ply(folder / "mesh.ply", torus(1, 0.4, 12, 8));
  const std::string normals =
      "<!DOCTYPE FilterScript>\n<FilterScript>\n<filter name=\"Invert Faces Orientation\">"
      "<Param type=\"RichBool\" name=\"forceFlip\" value=\"true\"/>"
      "<Param type=\"RichBool\" name=\"onlySelected\" value=\"false\"/></filter>\n</FilterScript>\n";
  write_text(folder / "other.mlx", normals);
  const ProgramResult run = run_program({"timeout", "60", "xvfb-run", "-a", folder / "prefix/bin/meshlabserver", "-i",
                                         folder / "mesh.ply", "-o", folder / "saved.ply", "-s", folder / "other.mlx"});
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_TRUE(fs::exists(folder / "saved.ply"));

  write_text(folder / "ours.mlx", filter_script({}));
  const ProgramResult ours = run_program({"timeout", "60", "xvfb-run", "-a", folder / "prefix/bin/meshlabserver", "-i",
                                          folder / "mesh.ply", "-s", folder / "ours.mlx"});
  EXPECT_NE(ours.status, 0);
  EXPECT_NE(ours.output.find("not found"), std::string::npos) << ours.output;
}

}  // namespace
}  // namespace test_support
