// SPDX-License-Identifier: GPL-3.0-or-later
// What the benchmark's verdict rests on: the estimators that were written from papers are right on exact meshes, noise
// has the statistics that its name says, and kept results come back.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "arguments.h"
#include "families/reference_results.h"
#include "families/surface_noise.h"
#include "peers/peer.h"
#include "support/shapes.h"

using namespace accuracy;
using integral_invariant::norm;

namespace {

/// A torus with axis distance 3 and tube radius 1, whose curvatures at the outer equator are 1 and 1/4.
struct ExactTorus {
  TriangleMesh mesh = test_support::torus(3, 1, 400, 130);
  double edge = test_support::average_edge_length(mesh);
  std::uint32_t vertex = 0;

  ExactTorus()
  {
    const auto distance = [&](std::uint32_t v) { return std::hypot(mesh.positions[v].x, mesh.positions[v].y); };
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
      if (distance(v) > distance(vertex)) vertex = v;
  }
  Vec3 normal() const { return integral_invariant::normalized(mesh.positions[vertex]); }
};

/// What each estimator that was written from a paper reads there. The spheres are fitted to the normals of vertices,
/// which the triangulation falsifies most at small radii; averages over a radius lose with its square.
std::vector<std::pair<std::string, Estimate>> estimates_on(const ExactTorus& torus, const Vec3& outward)
{
  constexpr double currents_radius = 3, spheres_radius = 8;  // in edges
  PeerList currents, spheres;
  add_corrected_current_peers(torus.mesh, currents);
  add_algebraic_sphere_peer(torus.mesh, spheres);
  std::vector<std::pair<std::string, Estimate>> estimates;
  const auto run = [&](const PeerList& peers, double radius) {
    for (const auto& peer : peers)
      estimates.emplace_back(peer->name(), peer->estimate({torus.vertex}, {outward}, radius * torus.edge).front());
  };
  run(currents, currents_radius);
  run(spheres, spheres_radius);
  return estimates;
}

TEST(OtherEstimators, AreExactOnAFineTorus)
{
  const ExactTorus torus;
  const auto estimates = estimates_on(torus, torus.normal());
  ASSERT_EQ(estimates.size(), 3u);
  for (const auto& [name, e] : estimates) {
    EXPECT_NEAR(e.kappa_max, 1, 0.01) << name;
    EXPECT_NEAR(e.kappa_min, 0.25, 0.01) << name;
    EXPECT_NEAR(std::abs(integral_invariant::normalized(e.dir_max).z), 1, 1e-3) << name;
  }
}

TEST(OtherEstimators, HaveTheSignOfTheOutwardNormal)
{
  const ExactTorus torus;
  for (const auto& [name, e] : estimates_on(torus, -torus.normal())) EXPECT_NEAR(e.kappa_min, -1, 0.01) << name;
}

/// Heights of noise over a plane, and the mean product of neighbours `distance` edges apart over their mean square.
struct PlaneNoise {
  static constexpr int size = 120;
  double variance = 0, correlation = 0;

  PlaneNoise(const std::function<void(NoisyMesh&)>& add, int distance)
  {
    std::mt19937 generator(5);
    NoisyMesh m;
    m.edge = 1;
    m.generator = &generator;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) m.mesh.positions.push_back({double(x), double(y), 0});
    m.normal.assign(m.mesh.positions.size(), {0, 0, 1});
    add(m);
    double products = 0, count = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x + distance < size; ++x) {
        const double a = m.mesh.positions[std::size_t(y * size + x)].z,
                     b = m.mesh.positions[std::size_t(y * size + x + distance)].z;
        variance += a * a;
        products += a * b;
        ++count;
      }
    correlation = products / variance;
    variance /= count;
  }
};

TEST(SurfaceNoise, WhiteNoiseIsIndependent)
{
  const PlaneNoise noise([](NoisyMesh& m) { add_white(m, 0.3); }, 1);
  EXPECT_NEAR(std::sqrt(noise.variance), 0.3, 0.01);
  EXPECT_NEAR(noise.correlation, 0, 0.03);
}

TEST(SurfaceNoise, CorrelatedNoiseHasItsVarianceAndLength)
{
  constexpr double length = 3;
  const PlaneNoise noise([](NoisyMesh& m) { add_correlated(m, 0.3, length); }, 3);
  EXPECT_NEAR(std::sqrt(noise.variance), 0.3, 0.03);
  EXPECT_NEAR(noise.correlation, std::exp(-0.5), 0.06);  // exp(−d²/2ℓ²) at d = ℓ
}

FamilyCell some_cell()
{
  FamilyCell cell;
  cell.family = "white_0.1";
  cell.shape.name = "torus";
  cell.level = 0.1;
  cell.seed = 7;
  return cell;
}

TEST(ReferenceResults, ComeBackFromTheFile)
{
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "reference_results_test.csv";
  std::filesystem::remove(path);
  const FamilyCell cell = some_cell();
  ReferenceResult result;
  result.method = "jet";
  Metrics small, large;
  small.mean = 0.02, small.direction = 5;
  large.mean = 0.01, large.direction = 8;
  result.take(small, 3);
  result.take(large, 12);
  ReferenceResults(path.string()).add(cell, 0.5, {result});

  const ReferenceResults read(path.string());
  const std::vector<ReferenceResult> found = read.find(cell, 0.5);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].method, "jet");
  EXPECT_DOUBLE_EQ(found[0].mean, 0.01);
  EXPECT_DOUBLE_EQ(found[0].mean_radius, 12);
  EXPECT_DOUBLE_EQ(found[0].direction, 5);
  EXPECT_DOUBLE_EQ(found[0].direction_radius, 3);
  EXPECT_TRUE(read.find(cell, 0.6).empty()) << "another mesh";
  std::filesystem::remove(path);
}

TEST(ReferenceResults, ADamagedLineIsRefused)
{
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "damaged_results_test.csv";
  std::ofstream(path) << "header\nwhite,0.1,7,0.5,jet\n";
  EXPECT_THROW(ReferenceResults(path.string()), std::runtime_error);
  std::filesystem::remove(path);
}

TEST(Arguments, AreReadByName)
{
  const Arguments a({"accuracy", "mode", "--seed", "12", "--cells", "torus"}, {"--seed", "--cells"}, "usage");
  EXPECT_EQ(a.number("--seed", 1), 12u);
  EXPECT_EQ(a.text("--cells"), "torus");
  EXPECT_EQ(a.text("--csv", "none"), "none");
}

TEST(Arguments, UnknownOnesAndMissingValuesAreRefused)
{
  EXPECT_THROW(Arguments({"accuracy", "mode", "--sed", "1"}, {"--seed"}, "usage"), std::invalid_argument);
  EXPECT_THROW(Arguments({"accuracy", "mode", "--seed"}, {"--seed"}, "usage"), std::invalid_argument);
}

}  // namespace
