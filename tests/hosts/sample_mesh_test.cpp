// SPDX-License-Identifier: GPL-3.0-or-later
// The sample that scripts/curvature measures when no mesh is named.
#include <gtest/gtest.h>

#include "hosts/host.h"

namespace test_support {
namespace {

const std::string program = "/samples/sample_mesh";

TEST(SampleMesh, IsOneClosedSurfaceOrientedOutward)
{
  const TemporaryFolder folder;
  const ProgramResult run = run_program({build_folder() + program, folder / "sample.ply"});
  ASSERT_EQ(run.status, 0) << run.output;
  const TriangleMesh mesh = read_ply(folder / "sample.ply").mesh();
  EXPECT_GT(mesh.positions.size(), 40000u);
  EXPECT_LT(mesh.positions.size(), 80000u);
  const integral_invariant::Surface surface(mesh);
  EXPECT_TRUE(surface.is_closed());
  EXPECT_FALSE(surface.report().inside_out);
  EXPECT_EQ(surface.report().zero_area_triangles, 0u);
  EXPECT_EQ(surface.report().unreferenced_vertices, 0u);
  EXPECT_EQ(mesh.triangles.size(), 2 * mesh.positions.size() - 4);  // Euler: a sphere, without a handle
}

TEST(SampleMesh, IsTheSameEveryTime)
{
  const TemporaryFolder folder;
  for (const char* name : {"a.ply", "b.ply"})
    ASSERT_EQ(run_program({build_folder() + program, folder / name, "0.05"}).status, 0);
  EXPECT_EQ(read_text(folder / "a.ply"), read_text(folder / "b.ply"));
}

TEST(SampleMesh, RefusesWhatItCannotMake)
{
  const TemporaryFolder folder;
  EXPECT_EQ(run_program({build_folder() + program}).status, 2);
  EXPECT_EQ(run_program({build_folder() + program, folder / "a.ply", "7"}).status, 2);
  EXPECT_EQ(run_program({build_folder() + program, folder / "none/a.ply", "0.1"}).status, 1);
}

}  // namespace
}  // namespace test_support
