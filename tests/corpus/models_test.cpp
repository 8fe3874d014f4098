// SPDX-License-Identifier: GPL-3.0-or-later
// The default run on every test model: finite values of the right length, order and orthogonality for each vertex, or,
// where there is no surface, a sentence that says so.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "integral_invariant/curvature.h"
#include "support/models.h"
#include "support/ply_file.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

/// Models without a face of positive area, and one whose coordinates have lost its shape: steps of 1/16, edges of 1/13.
const char* const no_surface[] = {"d_broken/syn_empty", "d_broken/syn_one_vertex", "d_broken/syn_points_only",
                                  "d_broken/syn_one_degenerate_triangle", "d_broken/syn_sphere_offset_1e6_float"};

bool has_surface(const std::string& name)
{
  return std::none_of(std::begin(no_surface), std::end(no_surface), [&](const char* n) { return name == n; });
}

void expect_sensible(const Result& r, std::size_t vertices)
{
  ASSERT_EQ(r.kappa_max.size(), vertices);
  std::size_t wrong = 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    const bool finite = std::isfinite(r.kappa_max[v]) && std::isfinite(r.kappa_min[v]) && std::isfinite(r.radius[v]) &&
                        is_finite(r.dir_max[v]) && is_finite(r.dir_min[v]);
    const bool ordered = r.kappa_max[v] >= r.kappa_min[v];
    const bool framed = std::abs(norm(r.dir_max[v]) - 1) < 1e-9 && std::abs(norm(r.dir_min[v]) - 1) < 1e-9 &&
                        std::abs(dot(r.dir_max[v], r.dir_min[v])) < 1e-9;
    const bool bounded = r.confidence[v] >= 0 && r.confidence[v] <= 1 &&
                         r.radius[v] >= r.scales.front() * (1 - 1e-12) && r.radius[v] <= r.scales.back() * (1 + 1e-12);
    wrong += !(finite && ordered && framed && bounded);
  }
  EXPECT_EQ(wrong, 0u) << "of " << vertices << " vertices";
}

class Models : public testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(Models, GiveSensibleValuesOrASentence)
{
  if (!std::filesystem::exists(models_folder()))
    GTEST_SKIP() << "not run: there is no folder " << models_folder() << " (II_MODELS names the folder of the models)";
  const std::vector<std::string> names = models_of(GetParam());
  ASSERT_FALSE(names.empty());
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = read_ply(model_path(name)).mesh();
    if (has_surface(name))
      expect_sensible(compute_curvature(mesh, {}), mesh.positions.size());
    else
      EXPECT_THROW(compute_curvature(mesh, {}), InputError);
  }
}

INSTANTIATE_TEST_SUITE_P(Category, Models,
                         testing::Values("a_closed_organic", "b_big", "c_open_scans", "d_broken", "e_cad",
                                         "g_ground_truth"),
                         [](const auto& i) { return std::string(i.param); });

TEST(Models, UndamagedVerticesOfTheBrokenSpheresHaveTheSpheresCurvature)
{
  // Damage that leaves the surface itself whole must not move the result: spheres of radius 1 (times the name's scale).
  const struct {
    const char* name;
    double radius;
  } spheres[] = {{"syn_sphere_tiny_1e-20", 1e-20},  {"syn_sphere_tiny_1e-6", 1e-6},
                 {"syn_sphere_huge_1e15", 1e15},    {"syn_sphere_inside_out", 1},
                 {"syn_sphere_duplicate_faces", 1}, {"syn_sphere_unreferenced_vertices", 1}};
  for (const auto& sphere : spheres) {
    SCOPED_TRACE(sphere.name);
    const std::string path = model_path(std::string("d_broken/") + sphere.name);
    if (!std::filesystem::exists(path))
      GTEST_SKIP() << "not run: there is no " << path << " (II_MODELS names the folder of the models)";
    const Result result = compute_curvature(read_ply(path).mesh(), {});
    std::size_t sound = 0;
    for (std::size_t v = 0; v < result.kappa_max.size(); ++v)
      if (result.confidence[v] > 0) {
        ++sound;
        EXPECT_NEAR(result.kappa_max[v] * sphere.radius, 1, 0.05);
        EXPECT_NEAR(result.kappa_min[v] * sphere.radius, 1, 0.05);
      }
    EXPECT_EQ(sound, 10242u);
  }
}
