// SPDX-License-Identifier: GPL-3.0-or-later
// docs/messages.md lists what scripts/curvature says besides its results: each sentence is provoked here, and what is
// said is listed there.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "hosts/host.h"
#include "support/message_list.h"
#include "support/shapes.h"

namespace test_support {
namespace {

namespace fs = std::filesystem;

/// Runs of scripts/curvature in a folder of their own, and what they said.
class CurvatureMessages : public testing::Test {
 protected:
  void SetUp() override
  {
    const Host host = find_host("2020.09");
    if (!host.unavailable.empty()) GTEST_SKIP() << host.unavailable;
    fs::permissions(folder_.path(), fs::perms(0755));
    write_ply(folder_ / "mesh.ply", torus(1, 0.4, 30, 16));
  }

  /// Runs `command` (a line for the shell, in which $curvature is the script) and keeps each sentence of the script's.
  void say(const std::string& command)
  {
    const std::string with_names = "curvature='" + source_folder() + "/scripts/curvature'\n" + command;
    const ProgramResult run = run_program({"timeout", "280", "bash", "-c", with_names}, folder_.path());
    EXPECT_NE(run.status, 124) << command;
    std::istringstream lines(run.output);
    bool said = false;
    for (std::string line; std::getline(lines, line);)
      if (line.rfind("curvature: ", 0) == 0) said = true, keep(line.substr(11), command);
    EXPECT_TRUE(said) << command << "\n" << run.output;
  }

  void keep(const std::string& sentence, const std::string& command)
  {
    const auto found =
        std::find_if(listed_.begin(), listed_.end(), [&](const auto& l) { return is_message(sentence, l); });
    if (found == listed_.end())
      ADD_FAILURE() << command << " says what is not listed: " << sentence;
    else
      met_.insert(*found);
  }

  /// A checkout of which only what the script itself needs is there, with these programs (name and body) before those
  /// of the machine, and sources of MeshLab that are taken for fetched. Begins a command whose $curvature is its
  /// script.
  std::string checkout(const std::string& name, const std::vector<std::pair<std::string, std::string>>& programs)
  {
    const fs::path root = folder_.path() / name;
    fs::create_directories(root / "programs");
    fs::create_directories(root / ".cache/meshlab-2020.09");
    fs::copy(source_folder() + "/scripts", root / "scripts", fs::copy_options::recursive);
    for (const char* file : {"CMakeLists.txt", "CMakePresets.json"})
      fs::copy(source_folder() + "/" + file, root / file);
    for (const auto& [program, body] : programs) {
      write_text((root / "programs" / program).string(), "#!/bin/sh\n" + body + "\n");
      fs::permissions(root / "programs" / program, fs::perms(0755));
    }
    return "PATH='" + (root / "programs").string() + "':$PATH; unset II_BUILD II_CACHE; curvature='" +
           (root / "scripts/curvature").string() + "'\n";
  }

  const TemporaryFolder folder_;
  const std::vector<std::string> listed_ = listed_messages("scripts/curvature");
  std::set<std::string> met_;
};

/// Prefix of a command that runs as a user who owns nothing here: the administrator may write everywhere.
std::string as_another_user() { return geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : ""; }

TEST_F(CurvatureMessages, AreAllListedAndProvoked)
{
  // About arguments and files.
  say("$curvature -mesh.ply");
  say("$curvature a.ply b.ply c.ply");
  say("$curvature nothing.ply");
  say("chmod 000 mesh.ply; " + as_another_user() + "$curvature mesh.ply; chmod 644 mesh.ply");
  say("$curvature mesh.ply out.obj");
  say("$curvature mesh.ply export_file=/x.ply");
  say("$curvature mesh.ply none/out.ply");
  say("mkdir here.ply; $curvature mesh.ply here.ply");
  say("$curvature mesh.ply ./mesh.ply");
  say("$curvature mesh.ply $(printf 'long%.0s' {1..64}).ply");
  say("cp mesh.ply $'m\\xe4sh.ply'; $curvature $'m\\xe4sh.ply'; rm $'m\\xe4sh.ply'");
  say("mkdir locked; chmod 555 locked; " + as_another_user() + "$curvature mesh.ply locked/out.ply");

  // About meshes that cannot be read.
  write_text(folder_ / "no_number.obj", "v 0 0 0\nv 1 0 oops\n");
  write_text(folder_ / "no_vertex.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n");
  write_text(folder_ / "flat.obj", "v 0 0\n");
  write_text(folder_ / "other.obj", "solid cube\n");
  for (const char* mesh : {"no_number.obj", "no_vertex.obj", "flat.obj", "other.obj"})
    say(std::string("$curvature ") + mesh);
  write_text(folder_ / "broken.ply", "this is no mesh\n");
  say("$curvature broken.ply");
  write_text(folder_ / "crash.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 77777777\n");
  say("$curvature crash.off");
  write_text(folder_ / "window.x3d", "<?xml version=\"1.0\"?>\n<X3D><Scene><Shape>\n");
  say("$curvature window.x3d");

  // About the filter and the picture.
  write_text(folder_ / "points.ply",
             "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
             "property float z\nend_header\n0 0 0\n");
  say("$curvature points.ply");
  write_ply(folder_ / "big.ply", icosphere(7));
  say("(until grep -qs 'loaded has' .curvature.*/log; do sleep 0.1; done; pkill -KILL -f \"meshlabserver -i "
      "$PWD/big.ply\") &\n"
      "$curvature big.ply engine=0 scales=20 radius_choice=0 estimator=0");
  say("$curvature quality=1");

  // About what the user's file has and MeshLab does not read.
  const std::string mesh = read_text(folder_ / "mesh.ply"), end = "end_header\n";
  const std::size_t vertices = mesh.find("element vertex"), body = mesh.find(end) + end.size();
  write_text(folder_ / "camera.ply", mesh.substr(0, vertices) + "element camera 1\nproperty int lens\n" +
                                         mesh.substr(vertices, body - vertices) + "lens" + mesh.substr(body));
  say("$curvature camera.ply");
  std::map<std::string, std::vector<double>> many;
  const TriangleMesh ball = icosphere(3);
  for (int i = 0; i < 200; ++i) many["property_" + std::to_string(i)].resize(ball.positions.size());
  write_ply(folder_ / "many.ply", ball, many);
  say("(ulimit -f 300; trap '' XFSZ; $curvature many.ply)");
  say("II_RENDER_OPTIONS=--nonsense $curvature mesh.ply");

  // About packages and the build.
  const std::pair<std::string, std::string> no_cmake{"cmake", "echo 'CMake Error: not today'; exit 1"};
  say(checkout("bare", {{"dpkg-query", "exit 1"}, {"apt-get", "exit 1"}, {"sudo", "exec \"$@\""}}) +
      "$curvature mesh.ply");
  say(checkout("failing", {{"cmake", "exit 0"}, {"ninja", "echo 'error: not today'; exit 1"}}) + "$curvature mesh.ply");
  const std::string elsewhere = "CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere\n";
  const std::string moved = checkout("moved", {no_cmake});
  fs::create_directories(folder_.path() / "moved/build/release");
  write_text(folder_ / "moved/build/release/CMakeCache.txt", elsewhere);
  say(moved + "$curvature mesh.ply");
  say(moved + "flock moved/build/release/.lock sleep 3 & sleep 0.5\n" + moved + "$curvature mesh.ply");
  fs::create_directory(folder_.path() / "foreign");
  write_text(folder_ / "foreign/CMakeCache.txt", elsewhere);
  say(moved + "II_BUILD=$PWD/foreign $curvature mesh.ply");
  say(moved + "chmod -R a-w moved; II_CACHE=$PWD/moved/.cache " + as_another_user() +
      "$curvature mesh.ply; chmod -R u+w moved");
  say(moved + "II_CACHE=$PWD/locked/cache " + as_another_user() + "$curvature mesh.ply");

  for (const std::string& message : listed_) EXPECT_TRUE(met_.count(message)) << "nothing provokes: " << message;
}

}  // namespace
}  // namespace test_support
