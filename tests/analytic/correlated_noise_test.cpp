// SPDX-License-Identifier: GPL-3.0-or-later
// Noise as pipelines leave it: smoothed, on a lattice; and what looks like it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "integral_invariant/curvature.h"
#include "integral_invariant/multiscale/noise_transfer.h"
#include "integral_invariant/support/pi.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

/// Each vertex half way to the mean of its neighbours, `passes` times.
TriangleMesh smoothed(TriangleMesh mesh, int passes)
{
  for (int pass = 0; pass < passes; ++pass) {
    std::vector<Vec3> sum(mesh.positions.size());
    std::vector<double> count(mesh.positions.size());
    for (const Triangle& t : mesh.triangles)
      for (int c = 0; c < 3; ++c) {
        sum[t[c]] += mesh.positions[t[(c + 1) % 3]];
        count[t[c]] += 1;
      }
    for (std::size_t v = 0; v < sum.size(); ++v)
      mesh.positions[v] = mesh.positions[v] * 0.5 + sum[v] * (0.5 / count[v]);
  }
  return mesh;
}

TriangleMesh smoothed_noise(int levels, double sigma, int passes, std::uint32_t seed)
{
  const TriangleMesh mesh = icosphere(levels, 2);
  return smoothed(with_normal_noise(mesh, sigma * average_edge_length(mesh), seed), passes);
}

double mean_error(const Result& r, double kappa)
{
  double sum = 0;
  for (std::size_t v = 0; v < r.kappa_max.size(); ++v)
    sum += std::abs(r.kappa_max[v] - kappa) + std::abs(r.kappa_min[v] - kappa);
  return sum / (2 * kappa * double(r.kappa_max.size()));
}

double least_error_of_a_constant_radius(const TriangleMesh& mesh, double kappa)
{
  double least = std::numeric_limits<double>::infinity();
  for (const double edges : {4, 6, 8, 11, 15}) {
    Parameters p;
    p.radius_choice = RadiusChoice::fixed;
    p.radius = edges * average_edge_length(mesh);
    least = std::min(least, mean_error(compute_curvature(mesh, p), kappa));
  }
  return least;
}

}  // namespace

// Correlated noise has 2 π ℓ² σ² in place of the area a vertex at small wavenumbers, and large balls see those alone,
// but for their rims: by the asymptotic form of the Bessel functions 6 or 4 terms of ℓ/(r √(2π)).
TEST(NoiseTransfer, LargeBallsSeeTheDensityAtWavenumberZero)
{
  const double area = std::sqrt(3.0) / 2, rim = 1 / (200 * std::sqrt(2 * pi));
  for (const double length : {0.5, 1.0, 3.0}) {
    const NoiseTransfer transfer(length);
    EXPECT_NEAR(transfer.curvature_ratio(200 * length), 2 * pi * length * length / area * (1 - 6 * rim),
                0.001 * length * length);
    EXPECT_NEAR(transfer.normal_ratio(200 * length), 2 * pi * length * length / area * (1 - 4 * rim),
                0.001 * length * length);
  }
}

// A ball much smaller than ℓ reads the curvature of the noise itself, whose mean square is 2 σ²/ℓ⁴.
TEST(NoiseTransfer, SmallBallsReadTheNoisesOwnCurvature)
{
  const double area = std::sqrt(3.0) / 2, length = 3, r = 0.3;
  const double white = 48 / pi * area / std::pow(r, 6);
  EXPECT_NEAR(NoiseTransfer(length).curvature_ratio(r) * white * std::pow(length, 4), 2, 0.02);
}

TEST(NoiseTransfer, IndependentNoiseIsLeftAsItIs)
{
  EXPECT_EQ(NoiseTransfer().curvature_ratio(5), 1);
  EXPECT_EQ(NoiseTransfer().normal_ratio_of(0.3), 1);
}

// Before the correlation was looked for, the errors here were 1.2 and 2.2 times the curvature itself.
TEST(CorrelatedNoise, SmoothedNoiseIsNoShape)
{
  for (const int passes : {1, 3})
    for (const std::uint32_t seed : {2u, 5u}) {
      const TriangleMesh mesh = smoothed_noise(4, 0.3, passes, seed);
      const Result r = compute_curvature(mesh, Parameters{});
      EXPECT_LT(mean_error(r, 0.5), 0.06) << passes << " passes, seed " << seed;
      EXPECT_LT(mean_error(r, 0.5), 1.5 * least_error_of_a_constant_radius(mesh, 0.5));
      EXPECT_GT(r.noise, 0.03 * r.average_edge);
      std::size_t covered = 0;
      for (std::size_t v = 0; v < r.kappa_max.size(); ++v)
        for (const double kappa : {r.kappa_max[v], r.kappa_min[v]})
          covered += std::abs(kappa - 0.5) < 2 * r.standard_error[v];
      // An honest error has 0.95; after one pass 0.78 is reached.
      EXPECT_GT(double(covered), 0.7 * 2 * double(r.kappa_max.size())) << passes << " passes, seed " << seed;
    }
}

TEST(CorrelatedNoise, RoundedCoordinatesAreNoShape)
{
  TriangleMesh mesh = icosphere(5, 2);
  const double step = 0.5 * average_edge_length(mesh);
  for (Vec3& p : mesh.positions)
    p = {std::round(p.x / step) * step, std::round(p.y / step) * step, std::round(p.z / step) * step};
  EXPECT_LT(mean_error(compute_curvature(mesh, Parameters{}), 0.5), 0.1);
}

// Bumps of six edges everywhere have the level and the smoothness of smoothed noise, but not its distribution.
TEST(CorrelatedNoise, EvenTexturesAreNoNoise)
{
  constexpr int side = 80;
  constexpr double k = pi / 6, height = 0.3 / k;
  TriangleMesh mesh;
  for (int i = 0; i <= side; ++i)
    for (int j = 0; j <= side; ++j)
      mesh.positions.push_back({double(i), double(j), height * std::sin(k * i) * std::sin(k * j)});
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const int a = i * (side + 1) + j, b = a + side + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  const Result r = compute_curvature(mesh, Parameters{});
  EXPECT_LT(r.noise, 0.01 * r.average_edge);
}

TEST(CorrelatedNoise, SmoothShapesHaveNone)
{
  for (const TriangleMesh& mesh : {icosphere(5, 2), torus(1, 0.4, 160, 64), bumpy_sphere(5)})
    EXPECT_LT(compute_curvature(mesh, Parameters{}).noise, 1e-3 * average_edge_length(mesh));
}
