// SPDX-License-Identifier: GPL-3.0-or-later
// The plugin in the real meshlabserver: equal to the core, and every refusal with a sentence and without harm.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "hosts/host.h"
#include "registry.h"
#include "support/models.h"
#include "support/shapes.h"

namespace test_support {
namespace {

namespace fs = std::filesystem;
using integral_invariant::filter::curvature_filter;
using integral_invariant::filter::Kind;
using integral_invariant::filter::ParameterSpec;

class MeshLabServer : public testing::Test {
 protected:
  void SetUp() override
  {
    if (!host_.unavailable.empty()) GTEST_SKIP() << host_.unavailable;
  }

  std::string written(const TriangleMesh& mesh)
  {
    write_ply(folder_ / "mesh.ply", mesh);
    return folder_ / "mesh.ply";
  }

  /// The run must fail, say `sentence`, and leave neither an export nor a saved mesh.
  void expect_refused(const std::string& mesh_file, const std::string& script, const std::string& sentence)
  {
    const HostRun run = run_script(host_, mesh_file, script, folder_ / "saved.ply");
    EXPECT_NE(run.status, 0);
    EXPECT_LT(run.status, 256);
    EXPECT_NE(run.log.find(sentence), std::string::npos) << "expected: " << sentence << "\nlog:\n" << run.log;
    EXPECT_FALSE(fs::exists(folder_ / "saved.ply"));
    EXPECT_FALSE(fs::exists(folder_ / "export.ply"));
  }

  std::string exporting(Assignments assignments = {}) const
  {
    assignments.push_back("export_file=" + (folder_ / "export.ply"));
    return filter_script(assignments);
  }

  const Host host_ = find_host("2020.09");
  const TemporaryFolder folder_;
};

TriangleMesh small_torus() { return torus(1, 0.4, 60, 30); }

TEST_F(MeshLabServer, ExportsWhatTheCoreComputes)
{
  const TriangleMesh mesh = with_normal_noise(small_torus(), 0.005);
  const Assignments parameters = {"scales=5", "alpha=0.8", "fft_cells_per_radius=3"};
  const HostRun run = run_script(host_, written(mesh), exporting(parameters), "");
  ASSERT_EQ(run.status, 0) << run.log;
  const PlyFile exported = read_ply(folder_ / "export.ply");
  expect_equal_to_core(exported, mesh, parameters);
  EXPECT_EQ(exported.triangles, mesh.triangles);
}

TEST_F(MeshLabServer, ExportsWhatTheCoreComputesWithAFixedRadius)
{
  const TriangleMesh mesh = small_torus();
  const Assignments parameters = {"radius_choice=1", "radius=0.25"};
  const HostRun run = run_script(host_, written(mesh), exporting(parameters), "");
  ASSERT_EQ(run.status, 0) << run.log;
  expect_equal_to_core(read_ply(folder_ / "export.ply"), mesh, parameters);
}

TEST_F(MeshLabServer, ExportsWhatTheCoreComputesOnAModel)
{
  const std::string model = models_folder() + "/a_closed_organic/spot_23k.ply";
  if (!fs::exists(model))
    GTEST_SKIP() << "not run: there is no " << model << " (II_MODELS names the folder of the models)";
  const HostRun run = run_script(host_, model, exporting(), "");
  ASSERT_EQ(run.status, 0) << run.log;
  expect_equal_to_core(read_ply(folder_ / "export.ply"), read_ply(model).mesh(), {});
}

TEST_F(MeshLabServer, FillsQualityRadiusAndColourOfTheMeshItself)
{
  const HostRun run = run_script(host_, written(small_torus()), exporting({"quality=2"}), folder_ / "saved.ply");
  ASSERT_EQ(run.status, 0) << run.log;
  const PlyFile saved = read_ply(folder_ / "saved.ply"), exported = read_ply(folder_ / "export.ply");
  EXPECT_EQ(saved.property("quality"), exported.property("ii_kmax"));
  EXPECT_EQ(saved.property("radius"), exported.property("ii_radius"));
  for (const char* channel : {"red", "green", "blue"}) EXPECT_EQ(saved.property(channel), exported.property(channel));
}

TEST_F(MeshLabServer, LaterStepsOfAScriptSeeTheNamedAttributes)
{
  std::string script = exporting();
  const std::string step =
      "<filter name=\"Per Vertex Quality Function\"><Param type=\"RichString\" name=\"q\" value=\"ii_radius\"/>"
      "<Param type=\"RichBool\" name=\"normalize\" value=\"false\"/>"
      "<Param type=\"RichBool\" name=\"map\" value=\"false\"/>"
      "<Param type=\"RichBool\" name=\"onselected\" value=\"false\"/></filter>\n";
  script.insert(script.find("</FilterScript>"), step);
  const HostRun run = run_script(host_, written(small_torus()), script, folder_ / "saved.ply");
  ASSERT_EQ(run.status, 0) << run.log;
  const PlyFile saved = read_ply(folder_ / "saved.ply"), exported = read_ply(folder_ / "export.ply");
  EXPECT_EQ(saved.property("quality"), exported.property("ii_radius"));
}

TEST_F(MeshLabServer, LogsASummary)
{
  const HostRun run = run_script(host_, written(small_torus()), filter_script({"scales=8"}), "");
  ASSERT_EQ(run.status, 0) << run.log;
  for (const char* word : {"1800 vertices", "Scales: 8", "% of the diagonal", "converged", "mean curvature", "Time: "})
    EXPECT_NE(run.log.find(word), std::string::npos) << word << "\n" << run.log;
}

TEST_F(MeshLabServer, ToleratesUnreferencedVerticesAndDegenerateAndDuplicateFaces)
{
  TriangleMesh mesh = small_torus();
  mesh.positions.push_back({5, 5, 5});
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back(mesh.triangles.front());
  const HostRun run = run_script(host_, written(mesh), exporting(), "");
  ASSERT_EQ(run.status, 0) << run.log;
  const PlyFile exported = read_ply(folder_ / "export.ply");
  expect_equal_to_core(exported, mesh, {});
  EXPECT_EQ(exported.triangles, mesh.triangles);
}

TEST_F(MeshLabServer, RefusesAPointCloud)
{
  TriangleMesh mesh = small_torus();
  mesh.triangles.clear();
  expect_refused(written(mesh), exporting(), "The mesh has no faces.");
}

TEST_F(MeshLabServer, RefusesAnOpenMeshForTheVoxelEngineWithTheNumberOfBoundaryEdges)
{
  TriangleMesh mesh = small_torus();
  mesh.triangles.pop_back();
  expect_refused(written(mesh), exporting({"engine=0"}), "3 boundary edges");
}

TEST_F(MeshLabServer, RefusesCoordinatesThatAreNotFinite)
{
  TriangleMesh mesh = small_torus();
  mesh.positions[7].x = std::numeric_limits<double>::quiet_NaN();
  expect_refused(written(mesh), exporting({"engine=0"}), "finite");
}

TEST_F(MeshLabServer, RefusesInconsistentOrientation)
{
  TriangleMesh mesh = small_torus();
  std::swap(mesh.triangles[11][0], mesh.triangles[11][1]);
  expect_refused(written(mesh), exporting({"engine=0"}), "orient");
}

TEST_F(MeshLabServer, RefusesRadiiInTheWrongOrder)
{
  expect_refused(written(small_torus()), exporting({"r_min=0.5", "r_max=0.2"}), "r_min");
}

TEST_F(MeshLabServer, RefusesAGridBeyondTheMemoryWithTheSizeItNeeds)
{
  expect_refused(written(small_torus()),
                 exporting({"engine=0", "fft_cells_per_radius=64", "scales=32", "memory_limit_mb=16"}), "MiB");
}

TEST_F(MeshLabServer, RefusesARadiusFarUnderTheEdges)
{
  expect_refused(written(small_torus()), exporting({"engine=0", "radius_choice=1", "radius=1e-9"}),
                 "average edge lengths");
}

TEST_F(MeshLabServer, RefusesAScriptWithoutAMesh)
{
  const HostRun run = run_script(host_, "", exporting(), "");
  EXPECT_LT(run.status, 256);
  EXPECT_NE(run.log.find("There is no mesh"), std::string::npos) << run.log;
  EXPECT_FALSE(fs::exists(folder_ / "export.ply"));
}

TEST_F(MeshLabServer, RefusesAnExportThatCannotBeWritten)
{
  const std::string missing = folder_ / "no such folder/export.ply";
  expect_refused(written(small_torus()), filter_script({"export_file=" + missing}), "no such folder");
}

/// Texts that are out of range for a parameter of that kind.
std::vector<std::string> bad_values(const ParameterSpec& spec)
{
  switch (spec.kind) {
    case Kind::boolean:
      return {};
    case Kind::save_file:
      return {};
    case Kind::integer:
      return {"-1"};
    case Kind::choice:
      return {"-1", "99"};
    case Kind::length:
      return {"-0.5", "nan"};
    case Kind::real:
      return {"-1", "1e30", "nan"};
  }
  return {};
}

TEST_F(MeshLabServer, RefusesEveryParameterOutOfItsRange)
{
  const std::string mesh_file = written(torus(1, 0.4, 12, 8));
  for (const ParameterSpec& spec : curvature_filter().parameters)
    for (const std::string& value : bad_values(spec)) {
      SCOPED_TRACE(spec.name + ("=" + value));
      expect_refused(mesh_file, with_value(exporting(), spec.name, value), std::string("'") + spec.name + "'");
    }
}

}  // namespace
}  // namespace test_support
