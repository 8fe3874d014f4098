// SPDX-License-Identifier: GPL-3.0-or-later
// scripts/curvature from end to end, as the README shows it.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <sstream>

#include "hosts/host.h"
#include "support/shapes.h"

namespace test_support {
namespace {

namespace fs = std::filesystem;

class CurvatureScript : public testing::Test {
 protected:
  void SetUp() override
  {
    const Host host = find_host("2020.09");
    if (!host.unavailable.empty()) GTEST_SKIP() << host.unavailable;
  }

  ProgramResult curvature(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), {"timeout", "280", source_folder() + "/scripts/curvature"});
    return run_program(arguments, folder_.path());
  }

  void expect_refused(const std::vector<std::string>& arguments, const std::string& sentence) const
  {
    const ProgramResult run = curvature(arguments);
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.output.find(sentence), std::string::npos) << "expected: " << sentence << "\noutput:\n" << run.output;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_.path()))
      EXPECT_EQ(entry.path().string().find("_curvature"), std::string::npos) << entry.path();
  }

  const TemporaryFolder folder_;
};

/// Width and height, from the first bytes of a PNG file.
std::pair<unsigned, unsigned> png_size(const std::string& path)
{
  const std::string bytes = read_text(path);
  if (bytes.size() < 24 || bytes.compare(1, 3, "PNG") != 0) return {0, 0};
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value * 256 + static_cast<unsigned char>(bytes[i]);
    return value;
  };
  return {number(16), number(20)};
}

TEST_F(CurvatureScript, LeavesExportPictureAndSummary)
{
  const TriangleMesh mesh = torus(1, 0.4, 60, 30);
  write_ply(folder_ / "a mesh's name.ply", mesh);
  const ProgramResult run = curvature({"a mesh's name.ply", "quality=1", "scales=4"});
  ASSERT_EQ(run.status, 0) << run.output;
  expect_equal_to_core(read_ply(folder_ / "a mesh's name_curvature.ply"), mesh, {"scales=4"});
  EXPECT_EQ(png_size(folder_ / "a mesh's name_curvature.png"), std::make_pair(1600u, 1200u));
  for (const char* word : {"1800 vertices", "Gaussian curvature", "Time: "})
    EXPECT_NE(run.output.find(word), std::string::npos) << word << "\n" << run.output;
}

TEST_F(CurvatureScript, ReadsOtherFormatsAndWritesWhereItIsTold)
{
  const TriangleMesh mesh = torus(1, 0.4, 30, 16);
  std::string off =
      "OFF\n" + std::to_string(mesh.positions.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vec3& p : mesh.positions)
    off += std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
  for (const Triangle& t : mesh.triangles)
    off += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  write_text(folder_ / "mesh.off", off);
  fs::create_directory(folder_ / "results");
  const ProgramResult run = curvature({"mesh.off", "results/here.ply"});
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_EQ(read_ply(folder_ / "results/here.ply").property("ii_kmax").size(), mesh.positions.size());
  EXPECT_TRUE(fs::exists(folder_ / "results/here.png"));
}

TEST_F(CurvatureScript, KeepsAllThatThePlyFileHad)
{
  const TriangleMesh mesh = torus(1, 0.4, 30, 16);
  const std::size_t n = mesh.positions.size();
  std::string header =
      "ply\nformat ascii 1.0\ncomment scanned on a Tuesday\nelement vertex " + std::to_string(n) +
      "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nproperty float temperature\nelement face " +
      std::to_string(mesh.triangles.size()) +
      "\nproperty list uchar int vertex_indices\nelement sensor 1\nproperty int serial\nend_header\n";
  std::ostringstream rows;
  rows.precision(17);
  for (std::size_t v = 0; v < n; ++v)
    rows << mesh.positions[v].x << ' ' << mesh.positions[v].y << ' ' << mesh.positions[v].z << " 10 20 30 " << v
         << '\n';
  for (const Triangle& t : mesh.triangles) rows << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  write_text(folder_ / "rich.ply", header + rows.str() + "4711\n");
  const ProgramResult run = curvature({"rich.ply"});
  ASSERT_EQ(run.status, 0) << run.output;
  const PlyFile found = read_ply(folder_ / "rich_curvature.ply");
  for (std::size_t v = 0; v < n; ++v) {
    EXPECT_EQ(found.property("x")[v], mesh.positions[v].x);
    EXPECT_EQ(found.property("temperature")[v], double(v));
    EXPECT_EQ(found.property("original_green")[v], 20);
  }
  EXPECT_EQ(found.property("ii_kmax").size(), n);
  EXPECT_EQ(found.triangles, mesh.triangles);
  const std::string text = read_text(folder_ / "rich_curvature.ply");
  for (const char* kept : {"comment scanned on a Tuesday\n", "property double y\n", "element sensor 1\n", "\n4711\n"})
    EXPECT_NE(text.find(kept), std::string::npos) << kept;
}

/// An OBJ file with normals and texture coordinates, whose faces name vertices from the front and from the back in
/// turn.
std::string obj_text(const TriangleMesh& mesh)
{
  std::ostringstream obj;
  obj.precision(17);
  for (const Vec3& p : mesh.positions) obj << "v " << p.x << ' ' << p.y << ' ' << p.z << "\nvn 0 0 1\n";
  obj << "vt 0.5 0.5\n";
  const std::ptrdiff_t count = std::ptrdiff_t(mesh.positions.size());
  bool from_the_back = false;
  for (const Triangle& t : mesh.triangles) {
    obj << 'f';
    for (const auto v : t)
      obj << ' ' << (from_the_back ? std::ptrdiff_t(v) - count : std::ptrdiff_t(v) + 1) << "/1/" << v + 1;
    obj << '\n';
    from_the_back = !from_the_back;
  }
  return obj.str();
}

TEST_F(CurvatureScript, ReadsObj)
{
  const TriangleMesh mesh = torus(1, 0.4, 30, 16);
  write_text(folder_ / "mesh.obj", obj_text(mesh));
  const ProgramResult run = curvature({"mesh.obj", "scales=4"});
  ASSERT_EQ(run.status, 0) << run.output;
  expect_equal_to_core(read_ply(folder_ / "mesh_curvature.ply"), mesh, {"scales=4"});
}

/// The corners of a concave polygon make triangles of its own area, not a fan across it.
TEST_F(CurvatureScript, CutsConcavePolygonsOfObjIntoTheirOwnTriangles)
{
  write_text(folder_ / "arrow.obj", "v 0 0 0\nv 2 2 0\nv 0 1 0\nv -2 2 0\nf 3 4 1 2\n");
  const ProgramResult run = curvature({"arrow.obj"});
  ASSERT_EQ(run.status, 0) << run.output;
  const TriangleMesh cut = read_ply(folder_ / "arrow_curvature.ply").mesh();
  double area = 0;
  for (const Triangle& t : cut.triangles)
    area += norm(cross(cut.positions[t[1]] - cut.positions[t[0]], cut.positions[t[2]] - cut.positions[t[0]])) / 2;
  EXPECT_NEAR(area, 2, 1e-6);
}

TEST_F(CurvatureScript, TakesNamesThatBeginWithADashAfterTwo)
{
  write_ply(folder_ / "-mesh.ply", torus(1, 0.4, 30, 16));
  const ProgramResult run = curvature({"scales=4", "--", "-mesh.ply", "-out.ply"});
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_TRUE(fs::exists(folder_ / "-out.ply"));
  EXPECT_TRUE(fs::exists(folder_ / "-out.png"));
}

/// A desktop asks Qt for Wayland, or writes decimal commas: that is not for the virtual screen.
TEST_F(CurvatureScript, DoesNotDependOnTheDesktop)
{
  const TriangleMesh mesh = torus(1, 0.4, 30, 16);
  write_ply(folder_ / "mesh.ply", mesh);
  const ProgramResult run =
      run_program({"timeout", "280", "env", "QT_QPA_PLATFORM=wayland", "WAYLAND_DISPLAY=wayland-0", "DISPLAY=:4711",
                   "QT_STYLE_OVERRIDE=none", "LC_ALL=de_DE.UTF-8", source_folder() + "/scripts/curvature", "mesh.ply",
                   "scales=4", "r_max=0.5"},
                  folder_.path());
  ASSERT_EQ(run.status, 0) << run.output;
  expect_equal_to_core(read_ply(folder_ / "mesh_curvature.ply"), mesh, {"scales=4", "r_max=0.5"});
}

TEST_F(CurvatureScript, RunsTwiceAtOnce)
{
  write_ply(folder_ / "mesh.ply", torus(1, 0.4, 60, 30));
  const std::string script = "'" + source_folder() + "/scripts/curvature' mesh.ply ";
  const ProgramResult run = run_program(
      {"timeout", "280", "bash", "-c",
       script + "a.ply quality=1 & first=$!; " + script + "b.ply quality=6; second=$?; wait $first && exit $second"},
      folder_.path());
  ASSERT_EQ(run.status, 0) << run.output;
  for (const char* name : {"a.ply", "a.png", "b.ply", "b.png"}) EXPECT_TRUE(fs::exists(folder_ / name)) << name;
}

/// Nothing that a script has started, and no file that is not whole, is left after a signal.
TEST_F(CurvatureScript, EndsWithAllItsChildrenOnASignal)
{
  write_ply(folder_ / "big.ply", icosphere(7));
  const std::string command = "export II_MARK=" + folder_.path().string() + R"(
started() { grep -lsz "^II_MARK=$II_MARK$" /proc/[0-9]*/environ | cut -d / -f 3 | grep -vx $$; }
')" + source_folder() + R"(/scripts/curvature' big.ply engine=0 scales=20 radius_choice=0 estimator=0 2>/dev/null >&2 &
until grep -qs 'loaded has' .curvature.*/log; do sleep 0.1; done
kill -TERM $!
wait $!
echo "status $?"
for program in $(started); do cat /proc/$program/comm 2>/dev/null; done | grep -E 'meshlab|Xvfb|curvature|sleep'
ls -A
)";
  const ProgramResult run = run_program({"timeout", "280", "bash", "-c", command}, folder_.path());
  EXPECT_EQ(run.output, "status 143\nbig.ply\n");
}

TEST_F(CurvatureScript, ListsTheParameters)
{
  const ProgramResult run = curvature({"--parameters"});
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.output.find("\nscales="), std::string::npos) << run.output;
}

TEST_F(CurvatureScript, IsReadyWithinASecondWhenNothingChanged)
{
  curvature({"--parameters"});
  const auto start = std::chrono::steady_clock::now();
  curvature({"--parameters"});
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  RecordProperty("milliseconds", int(1000 * elapsed.count()));
  EXPECT_LT(elapsed.count(), 1.0);
}

TEST_F(CurvatureScript, RefusesAMeshThatIsNotThere)
{
  expect_refused({"nothing.ply"}, "there is no mesh file nothing.ply");
}

TEST_F(CurvatureScript, RefusesAMeshThatMeshLabCannotRead)
{
  write_text(folder_ / "broken.ply", "this is no mesh\n");
  expect_refused({"broken.ply"}, "MeshLab cannot read the mesh");
}

TEST_F(CurvatureScript, RefusesUnknownAndBadParameters)
{
  write_ply(folder_ / "mesh.ply", torus(1, 0.4, 30, 16));
  expect_refused({"mesh.ply", "colour=red"}, "There is no parameter 'colour'");
  expect_refused({"mesh.ply", "scales=0"}, "The parameter 'scales' is '0'");
  expect_refused({"mesh.ply", "export_file=/x.ply"}, "second argument");
}

TEST_F(CurvatureScript, PassesOnWhyTheFilterRefused)
{
  TriangleMesh mesh = torus(1, 0.4, 30, 16);
  mesh.triangles.pop_back();
  write_ply(folder_ / "open.ply", mesh);
  expect_refused({"open.ply", "engine=0"}, "boundary edges");
}

TEST_F(CurvatureScript, RefusesAnOutputItCannotWrite)
{
  write_ply(folder_ / "mesh.ply", torus(1, 0.4, 30, 16));
  expect_refused({"mesh.ply", "none/out.ply"}, "there is no folder none");
  expect_refused({"mesh.ply", "out.obj"}, "must end in .ply");
  expect_refused({"mesh.ply", "./mesh.ply"}, "would overwrite the mesh");
}

}  // namespace
}  // namespace test_support
