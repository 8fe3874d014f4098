// SPDX-License-Identifier: GPL-3.0-or-later
// The runner as users of later releases meet it: options, exit statuses, what it saves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "hosts/host.h"
#include "support/full_disk.h"
#include "support/message_list.h"
#include "support/shapes.h"

namespace test_support {
namespace {

namespace fs = std::filesystem;

class ScriptRunner : public testing::Test {
 protected:
  void SetUp() override
  {
    if (!host_.unavailable.empty()) GTEST_SKIP() << host_.unavailable;
    write_ply(folder_ / "mesh.ply", torus(1, 0.4, 30, 16));
  }

  ProgramResult run(const std::vector<std::string>& arguments) const
  {
    return run_program(runner_command(host_.release, arguments), folder_.path());
  }

  void expect_failure(const std::vector<std::string>& arguments, int status, const std::string& sentence) const
  {
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.status, status) << result.output;
    EXPECT_NE(result.output.find(sentence), std::string::npos) << "expected: " << sentence << "\noutput:\n"
                                                               << result.output;
    EXPECT_TRUE(is_listed(last_words(result.output))) << "not in docs/messages.md: " << last_words(result.output);
    EXPECT_FALSE(fs::exists(folder_ / "saved.ply"));
  }

  /// What the program says at the end.
  static std::string last_words(const std::string& output)
  {
    const std::string own_name = "meshlab_script_runner: ";
    const std::size_t begin = output.rfind(own_name);
    return begin == std::string::npos
               ? ""
               : output.substr(begin + own_name.size(), output.find('\n', begin) - begin - own_name.size());
  }

  static bool is_listed(const std::string& message)
  {
    const std::vector<std::string> listed = listed_messages("The runner");
    return std::any_of(listed.begin(), listed.end(), [&](const std::string& l) { return is_message(message, l); });
  }

  std::string script(const std::string& text) const
  {
    write_text(folder_ / "script.mlx", "<!DOCTYPE FilterScript>\n<FilterScript>\n" + text + "\n</FilterScript>\n");
    return folder_ / "script.mlx";
  }

  const Host host_ = find_host("2025.07");
  const TemporaryFolder folder_;
};

const char* const invert =
    "<filter name=\"Invert Faces Orientation\"><Param type=\"RichBool\" name=\"forceFlip\" value=\"true\"/></filter>";

TEST_F(ScriptRunner, RunsMeshLabsOwnFiltersWithDefaultsForWhatTheScriptLeavesOut)
{
  const ProgramResult result = run({"-i", "mesh.ply", "-s", script(invert), "-o", "saved.ply"});
  ASSERT_EQ(result.status, 0) << result.output;
  const TriangleMesh saved = read_ply(folder_ / "saved.ply").mesh(), mesh = read_ply(folder_ / "mesh.ply").mesh();
  EXPECT_TRUE(integral_invariant::Surface(saved).report().inside_out);
  EXPECT_EQ(saved.positions.size(), mesh.positions.size());
}

TEST_F(ScriptRunner, ConvertsWithoutAScript)
{
  ASSERT_EQ(run({"-i", "mesh.ply", "-o", "mesh.off"}).status, 0);
  EXPECT_NE(read_text(folder_ / "mesh.off").substr(0, 5).find("OFF\n"), std::string::npos);
  ASSERT_EQ(run({"-i", "mesh.off", "-o", "ascii.ply", "--ascii"}).status, 0);
  EXPECT_NE(read_text(folder_ / "ascii.ply").find("format ascii"), std::string::npos);
}

TEST_F(ScriptRunner, SavesNamedAttributes)
{
  write_text(folder_ / "ours.mlx", filter_script({}));
  const ProgramResult result = run({"--plugin", host_.plugin, "-i", "mesh.ply", "-s", "ours.mlx", "-o", "saved.ply"});
  ASSERT_EQ(result.status, 0) << result.output;
  const PlyFile saved = read_ply(folder_ / "saved.ply");
  EXPECT_EQ(saved.property("ii_radius"), saved.property("radius"));
  EXPECT_NE(read_text(folder_ / "saved.ply").find("ii_dirmax"), std::string::npos);
}

TEST_F(ScriptRunner, QuietSaysNothing)
{
  EXPECT_EQ(run({"-q", "-i", "mesh.ply", "-s", script(invert), "-o", "saved.ply"}).output, "");
}

TEST_F(ScriptRunner, TellsHelpVersionAndFilters)
{
  for (const char* option : {"--help", "--version", "--list-filters"}) EXPECT_EQ(run({option}).status, 0) << option;
  EXPECT_NE(run({"--help"}).output.find("Exit status"), std::string::npos);
  EXPECT_NE(run({"--version"}).output.find("2025"), std::string::npos);
  EXPECT_NE(run({"--list-filters"}).output.find("Invert Faces Orientation\n"), std::string::npos);
}

TEST_F(ScriptRunner, EndsWith1WhereAFilterFails)
{
  write_text(folder_ / "ours.mlx", with_value(filter_script({}), "alpha", "-3"));
  expect_failure({"--plugin", host_.plugin, "-i", "mesh.ply", "-s", "ours.mlx", "-o", "saved.ply"}, 1, "'alpha'");
  const std::string ours = filter_script({});
  const std::size_t begin = ours.find("<filter");
  const std::string after = ours.substr(begin, ours.find("</FilterScript>") - begin);
  expect_failure({"--plugin", host_.plugin, "-i", "mesh.ply", "-s",
                  script("<filter name=\"Delete Current Mesh\"/>" + after), "-o", "saved.ply"},
                 1, "There is no mesh to measure: open one first.");
}

TEST_F(ScriptRunner, EndsWith2WhereTheCommandLineIsBad)
{
  expect_failure({}, 2, "No mesh was named");
  expect_failure({"-i", "mesh.ply"}, 2, "Nothing was asked for");
  expect_failure({"--colour"}, 2, "no option --colour");
  expect_failure({"-i"}, 2, "needs a value");
}

TEST_F(ScriptRunner, EndsWith3WhereAPluginIsNotLoaded)
{
  expect_failure({"--plugin", "nothing.so", "--list-filters"}, 3, "nothing.so");
  expect_failure({"--plugin-folder", "nowhere", "--list-filters"}, 3, "nowhere");
}

TEST_F(ScriptRunner, EndsWith4WhereAMeshIsNotRead)
{
  expect_failure({"-i", "nothing.ply", "-o", "saved.ply"}, 4, "there is no mesh file nothing.ply");
  write_text(folder_ / "broken.ply", "no mesh");
  expect_failure({"-i", "broken.ply", "-o", "saved.ply"}, 4, "broken.ply");
  write_text(folder_ / "mesh.xyzzy", "no mesh");
  expect_failure({"-i", "mesh.xyzzy", "-o", "saved.ply"}, 4, "mesh.xyzzy");
}

TEST_F(ScriptRunner, EndsWith5WhereAScriptCannotBeUsed)
{
  const auto with = [&](const std::string& file) {
    return std::vector<std::string>{"-i", "mesh.ply", "-s", file, "-o", "saved.ply"};
  };
  expect_failure(with("nothing.mlx"), 5, "there is no script nothing.mlx");
  expect_failure(with(script("")), 5, "no filter script");
  expect_failure(with(script("<filter name=\"Make Coffee\"/>")), 5, "there is no filter 'Make Coffee'");
  expect_failure(with(script("<filter name=\"Invert Faces Orientation\"><Param type=\"RichBool\" name=\"sugar\" "
                             "value=\"true\"/></filter>")),
                 5, "has no parameter 'sugar'");
  expect_failure(with(script("<filter name=\"Invert Faces Orientation\"><Param type=\"RichInt\" name=\"forceFlip\" "
                             "value=\"1\"/></filter>")),
                 5, "'forceFlip'");
  expect_failure(with(script("<filter name=\"Ambient Occlusion\"/>")), 5, "needs MeshLab's window");
}

TEST_F(ScriptRunner, EndsWith6WhereTheOutputIsNotWritten)
{
  expect_failure({"-i", "mesh.ply", "-o", "mesh.xyzzy"}, 6, "format");
  expect_failure({"-i", "mesh.ply", "-o", "nowhere/saved.ply"}, 6, "cannot write nowhere/saved.ply");
  expect_failure({"-i", "mesh.ply", "-s", script("<filter name=\"Delete Current Mesh\"/>"), "-o", "saved.ply"}, 6,
                 "left no mesh to save");
  fs::create_directory(folder_ / "folder.ply");
  expect_failure({"-i", "mesh.ply", "-o", "folder.ply"}, 6, "cannot write folder.ply: it is a folder");
}

TEST_F(ScriptRunner, SavesAWholeFileOrNoneOnADiskOfAnySize)
{
  ASSERT_EQ(run({"-i", "mesh.ply", "-o", "whole.ply"}).status, 0);
  const std::string whole = read_text(folder_ / "whole.ply"), disk = folder_ / "disk",
                    saved = folder_ / "disk/saved.ply";
  fs::create_directory(disk);
  constexpr std::size_t step = 4096, room_to_spare = 128 << 10;
  for (std::size_t room = 2 * step; room < whole.size() + 2 * step; room += step) {
    const SmallDisk small(disk, room);
    if (!small.unavailable().empty()) GTEST_SKIP() << "only root can do this: " << small.unavailable();
    const ProgramResult result = run({"-i", "mesh.ply", "-o", "disk/saved.ply"});
    EXPECT_EQ(result.status, 6) << room << ": " << result.output;
    EXPECT_TRUE(is_listed(last_words(result.output))) << last_words(result.output);
    EXPECT_TRUE(fs::is_empty(disk)) << room;
  }
  const SmallDisk large(disk, whole.size() + room_to_spare);
  EXPECT_EQ(run({"-i", "mesh.ply", "-o", "disk/saved.ply"}).status, 0);
  EXPECT_EQ(read_text(saved), whole);
}

}  // namespace
}  // namespace test_support
