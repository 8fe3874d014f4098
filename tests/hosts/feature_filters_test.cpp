// SPDX-License-Identifier: GPL-3.0-or-later
// The filters for features in the real meshlabserver: their layers, selections and files against the core.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "hosts/host.h"
#include "integral_invariant/curvature.h"
#include "integral_invariant/features/crest_lines.h"
#include "integral_invariant/features/signature.h"
#include "integral_invariant/mesh/canonical_mesh.h"
#include "support/feature_shapes.h"

namespace test_support {
namespace {

namespace fs = std::filesystem;
using namespace integral_invariant;
using namespace integral_invariant::filter;

const Vec3 axes{2, 1.4, 0.8};

/// In each release, by its own name.
class FeatureFilters : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override
  {
    if (!host_.unavailable.empty()) GTEST_SKIP() << host_.unavailable;
  }

  HostRun run(const Filter& filter, const TriangleMesh& mesh, Assignments assignments, const std::string& saved = "")
  {
    write_ply(folder_ / "mesh.ply", mesh);
    return run_script(host_, folder_ / "mesh.ply", filter_script(assignments, filter),
                      saved.empty() ? "" : folder_ / saved);
  }

  const Host host_ = find_host(GetParam());
  const TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Releases, FeatureFilters, testing::Values("2020.09", "2022.02", "2025.07"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           name[4] = '_';
                           return name;
                         });

/// Lines that begin so.
std::size_t count_lines(const std::string& file, const std::string& start)
{
  std::ifstream in(file);
  std::size_t count = 0;
  for (std::string line; std::getline(in, line);) count += line.rfind(start, 0) == 0;
  return count;
}

TEST_P(FeatureFilters, CrestLinesAreTheCoresAndMeshLabSavesTheirEdges)
{
  // Without symmetry: on it the derivative is rounding, and so is the side of an edge that a line passes.
  const TriangleMesh mesh = with_tangential_jitter(ellipsoid(4, axes), 0.02);
  const HostRun result =
      run(crest_lines_filter(), mesh, {"lift=0", "export_file=" + (folder_ / "crest.ply")}, "crest.obj");
  ASSERT_EQ(result.status, 0) << result.log;
  const PlyFile exported = read_ply(folder_ / "crest.ply");

  const TriangleMesh single = make_canonical_mesh(in_single_precision(mesh)).mesh;  // as the filter does
  Execution execution;
  const auto lines = find_crest_lines(Surface(single), curvature_field(compute_curvature(single, {})), {}, execution);
  ASSERT_EQ(lines.size(), 1u);
  ASSERT_EQ(exported.property("x").size(), lines[0].points.size());
  EXPECT_EQ(exported.edges.size(), lines[0].points.size());  // it is closed
  for (std::size_t i = 0; i < lines[0].points.size(); ++i) {
    const Vec3 p = interpolate(single.positions, lines[0].points[i]);
    EXPECT_NEAR(exported.property("x")[i], p.x, 1e-5);
    EXPECT_NEAR(exported.property("z")[i], p.z, 1e-5);
    EXPECT_NEAR(exported.property("ii_strength")[i], lines[0].strength, 1e-4);
    EXPECT_EQ(exported.property("ii_kind")[i], 1);
  }
  EXPECT_EQ(count_lines(folder_ / "crest.obj", "l "), exported.edges.size());
  EXPECT_EQ(count_lines(folder_ / "crest.obj", "f "), 0u);
}

TEST_P(FeatureFilters, DirectionsAreDrawnAsLinesAndAsSegments)
{
  const TriangleMesh mesh = torus(1, 0.4, 80, 32);
  const std::string file = "export_file=" + (folder_ / "lines.ply");
  HostRun result = run(directions_filter(), mesh, {"spacing=0.2", "minimal=true", file});
  ASSERT_EQ(result.status, 0) << result.log;
  EXPECT_NE(result.log.find("of them closed"), std::string::npos) << result.log;
  // Together the lines of a family are about as long as area / spacing, and an edge of theirs is under 0.1.
  EXPECT_GT(read_ply(folder_ / "lines.ply").edges.size(), 2 * 4 * 9.87 * 0.4 / 0.2 / 0.1 * 0.8);
  result = run(directions_filter(), mesh, {"style=1", "spacing=0.2", file});
  ASSERT_EQ(result.status, 0) << result.log;
  const PlyFile segments = read_ply(folder_ / "lines.ply");
  EXPECT_EQ(segments.property("x").size(), 2 * segments.edges.size());
}

TEST_P(FeatureFilters, RidgesAreColouredAndLaterStepsSeeThem)
{
  const TriangleMesh mesh = box_with_ridge(2.5, 1, 0.06, 1.237, 0.3, 0.3);
  write_ply(folder_ / "mesh.ply", mesh);
  std::string script =
      filter_script({"threshold=1", "high_curvature=1.6", "low_curvature=1.2"}, ridges_and_valleys_filter());
  script.insert(
      script.find("</FilterScript>"),
      "<filter name=\"Per Vertex Quality Function\"><Param type=\"RichString\" name=\"q\" value=\"ii_feature\"/>"
      "<Param type=\"RichBool\" name=\"normalize\" value=\"false\"/>"
      "<Param type=\"RichBool\" name=\"map\" value=\"false\"/>"
      "<Param type=\"RichBool\" name=\"onselected\" value=\"true\"/></filter>\n");
  const HostRun result = run_script(host_, folder_ / "mesh.ply", script, folder_ / "saved.ply");
  ASSERT_EQ(result.status, 0) << result.log;
  const PlyFile saved = read_ply(folder_ / "saved.ply");
  std::size_t selected = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const bool ridge = saved.property("quality")[v] == 1;  // written where the vertex is selected
    selected += ridge;
    if (ridge) { EXPECT_GT(saved.property("red")[v], saved.property("blue")[v]); }
    const Vec3& p = mesh.positions[v];
    if (std::abs(p.x - 1.237) < 0.05 && p.z > 1.2 && p.y > 0.5 && p.y < 2) { EXPECT_TRUE(ridge); }
    if (p.z == 0 && std::abs(p.x - 1.25) < 0.5 && std::abs(p.y - 1.25) < 0.5) { EXPECT_FALSE(ridge); }
  }
  EXPECT_GT(selected, 100u);
}

TEST_P(FeatureFilters, SignatureIsTheCores)
{
  const TriangleMesh mesh = torus(1, 0.4, 60, 30);
  const HostRun result = run(signature_filter(), mesh, {"scales=3", "scale=2", "export_file=" + (folder_ / "sig.ply")});
  ASSERT_EQ(result.status, 0) << result.log;
  const PlyFile exported = read_ply(folder_ / "sig.ply");
  Parameters parameters;
  parameters.scales = 3;
  const Signature expected = compute_signature(in_single_precision(mesh), parameters);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_NEAR(exported.property("ii_volume_3")[v], expected.of(SignatureQuantity::volume)[2][v], 1e-5);
    EXPECT_NEAR(exported.property("ii_mean_1")[v], expected.of(SignatureQuantity::mean)[0][v], 1e-4);
    EXPECT_EQ(exported.property("quality")[v], exported.property("ii_volume_2")[v]);
  }
  EXPECT_EQ(exported.triangles, mesh.triangles);
}

TEST_P(FeatureFilters, RefuseWithASentence)
{
  const TriangleMesh mesh = torus(1, 0.4, 20, 10);
  const std::pair<const Filter*, std::pair<Assignments, const char*>> cases[] = {
      {&crest_lines_filter(), {{"ridges=false", "valleys=false"}, "Nothing is asked for"}},
      {&directions_filter(), {{"maximal=false"}, "Nothing is asked for"}},
      {&ridges_and_valleys_filter(), {{"threshold=1"}, "high_curvature"}},
      {&ridges_and_valleys_filter(), {{"low_percentile=99"}, "low_percentile"}},
      {&signature_filter(), {{"scale=9"}, "'scale' is 9"}},
  };
  for (const auto& [filter, expected] : cases) {
    const HostRun result = run(*filter, mesh, expected.first, "saved.obj");
    EXPECT_NE(result.status, 0);
    EXPECT_NE(result.log.find(expected.second), std::string::npos) << result.log;
    EXPECT_FALSE(fs::exists(folder_ / "saved.obj"));
  }
}

}  // namespace
}  // namespace test_support
