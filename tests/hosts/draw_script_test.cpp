// SPDX-License-Identifier: GPL-3.0-or-later
// scripts/draw from end to end: a mesh becomes a sheet inside the real MeshLab.
#include <gtest/gtest.h>

#include <filesystem>

#include "hosts/host.h"
#include "support/shapes.h"

namespace test_support {
namespace {

namespace fs = std::filesystem;

class DrawScript : public testing::Test {
 protected:
  void SetUp() override
  {
    const Host host = find_host("2020.09");
    if (!host.unavailable.empty()) GTEST_SKIP() << host.unavailable;
  }

  ProgramResult draw(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), {"timeout", "280", source_folder() + "/scripts/draw"});
    return run_program(arguments, folder_.path());
  }

  void expect_refused(const std::vector<std::string>& arguments, const std::string& sentence) const
  {
    const ProgramResult run = draw(arguments);
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.output.find(sentence), std::string::npos) << "expected: " << sentence << "\noutput:\n" << run.output;
  }

  const TemporaryFolder folder_;
};

TEST_F(DrawScript, LeavesASheetOfEachKind)
{
  write_ply(folder_ / "ring.ply", torus(20, 8, 60, 30));
  ProgramResult run = draw({"ring.ply", "sheet_scale=0.5", "hidden_lines=1"});
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_NE(run.output.find("Sheet: "), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("scale 1 : 2"), std::string::npos) << run.output;
  const std::string svg = read_text(folder_ / "ring_drawing.svg");
  EXPECT_NE(svg.find("id=\"front_contours\""), std::string::npos);
  EXPECT_NE(svg.find("id=\"left_hidden\""), std::string::npos);
  run = draw({"ring.ply", "ring.pdf", "view=0"});
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_EQ(read_text(folder_ / "ring.pdf").rfind("%PDF-1.5", 0), 0u);
  run = draw({"ring.ply", "ring.dxf", "view=8", "toward_x=1", "toward_z=1"});
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_NE(read_text(folder_ / "ring.dxf").find("view_contours"), std::string::npos);
}

TEST_F(DrawScript, SaysWhatIsWrong)
{
  write_ply(folder_ / "ring.ply", torus(20, 8, 60, 30));
  expect_refused({}, "no mesh was named. scripts/draw --help tells the usage.");
  expect_refused({"nothing.ply"}, "there is no mesh file nothing.ply");
  expect_refused({"ring.ply", "ring.png"}, "the output's name must end in .svg, .pdf or .dxf, not as in ring.png.");
  expect_refused({"ring.ply", "nowhere/ring.svg"}, "there is no folder nowhere to write nowhere/ring.svg into.");
  expect_refused({"--colour", "ring.ply"}, "unknown option --colour. scripts/draw --help tells what there is.");
  expect_refused({"ring.ply", "sheet_scale=-1"}, "'sheet_scale'");
  expect_refused({"ring.ply", "significance=1e5", "contours=false"},
                 "The drawing is empty: no line was found in any view.");
  EXPECT_FALSE(fs::exists(folder_ / "ring_drawing.svg"));
}

}  // namespace
}  // namespace test_support
