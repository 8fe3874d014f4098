// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/multiscale/scale_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "integral_invariant/ball_curvature/offset_free.h"

using namespace integral_invariant;

namespace {

const std::vector<double> radii{1.5, 2.12132, 3, 4.24264, 6, 8.48528, 12};

/// Places on a square lattice, all balls whole.
struct Setting {
  explicit Setting(int side)
  {
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) places.push_back({double(i), double(j), 0});
    balls.source.assign(places.size() * radii.size(), Source::ball);
    balls.largest.assign(places.size(), int(radii.size()) - 1);
    least_radius.assign(places.size(), 0);
    for (std::size_t i = 0; i + 1 < radii.size(); ++i)
      pools.emplace_back(places, std::max(8.0, 2 * radii[i + 1]), execution);
  }

  /// Truth plus slope · r² plus noise whose differences between scales are independent.
  Signal signal(double truth, double slope, double noise_density)
  {
    Signal s(1, GainSharing::joint, places.size() * radii.size());
    std::mt19937 generator(5);
    std::normal_distribution<double> gauss;
    for (std::size_t v = 0; v < places.size(); ++v) {
      double noise = 0, variance_before = 0;
      for (std::size_t i = radii.size(); i-- > 0;) {
        const double variance = disc_variance::mean_curvature * noise_density / std::pow(radii[i], 6);
        noise += std::sqrt(variance - variance_before) * gauss(generator);
        variance_before = variance;
        s.values[v * radii.size() + i] = {float(truth + slope * radii[i] * radii[i] + noise), 0};
      }
    }
    return s;
  }

  /// As if the noise had the density given.
  FilteredSignal run(Signal& s, double noise_density, bool predict = true)
  {
    for (std::size_t place = 0; place < places.size() * radii.size(); ++place)
      s.noise[place] = float(disc_variance::mean_curvature * noise_density / std::pow(radii[place % radii.size()], 6));
    const FilterContext evidence{radii, balls, least_radius, pools, predict};
    return ScaleFilter(evidence, execution).run(s);
  }
  FilteredSignal run(Signal&& s, double noise_density) { return run(s, noise_density); }

  Execution execution{1};
  std::vector<Vec3> places;
  ValidScales balls;
  std::vector<double> least_radius;
  std::vector<KernelSum> pools;
};

/// Over the places that have all of their neighbourhood.
double rms_error(const Setting& setting, const FilteredSignal& result, double truth)
{
  double squares = 0, count = 0, extent = setting.places.back().x;
  for (std::size_t v = 0; v < setting.places.size(); ++v) {
    const Vec3& p = setting.places[v];
    if (std::min({p.x, p.y, extent - p.x, extent - p.y}) < extent / 4) continue;
    squares += (result.value[v][0] - truth) * (result.value[v][0] - truth);
    ++count;
  }
  return std::sqrt(squares / count);
}

}  // namespace

TEST(ScaleFilter, ConstantSignalIsReproduced)
{
  Setting setting(30);
  const FilteredSignal result = setting.run(setting.signal(0.7, 0, 0), 1e-4);
  EXPECT_NEAR(rms_error(setting, result, 0.7), 0, 1e-6);
}

TEST(ScaleFilter, BiasThatGrowsWithTheSquareOfTheRadiusIsRemoved)
{
  Setting setting(30);
  Signal biased = setting.signal(0.7, 1e-3, 0);
  EXPECT_NEAR(rms_error(setting, setting.run(biased, 1e-8), 0.7), 0, 1e-4);
  EXPECT_GT(rms_error(setting, setting.run(biased, 1e-8, false), 0.7), 1e-3);
}

TEST(ScaleFilter, PureNoiseIsAveragedByTheLargestBall)
{
  Setting setting(100);
  const double density = 0.01;
  const FilteredSignal result = setting.run(setting.signal(0.7, 0, density), density);
  const double largest_ball = std::sqrt(disc_variance::mean_curvature * density / std::pow(radii.back(), 6));
  EXPECT_LT(rms_error(setting, result, 0.7), 2 * largest_ball);
}

TEST(ScaleFilter, BiasUnderNoiseIsRemovedBetterThanByAnyOneScale)
{
  Setting setting(100);
  const double density = 0.01, slope = 2e-4;
  const FilteredSignal result = setting.run(setting.signal(0.7, slope, density), density);
  for (const double r : radii) {
    const double variance = disc_variance::mean_curvature * density / std::pow(r, 6);
    EXPECT_LT(rms_error(setting, result, 0.7), std::sqrt(variance + slope * slope * r * r * r * r));
  }
}

TEST(ScaleFilter, TheLargestScaleAllowedIsTheLastThatCounts)
{
  Setting setting(20);
  Signal s = setting.signal(0.7, 0, 0);
  for (std::size_t v = 0; v < setting.places.size(); ++v) {
    setting.balls.largest[v] = 3;
    for (std::size_t i = 4; i < radii.size(); ++i) s.values[v * radii.size() + i] = {100, 0};
  }
  EXPECT_NEAR(rms_error(setting, setting.run(s, 1e-4), 0.7), 0, 1e-6);
}

TEST(ScaleFilter, AComponentOfNoiseAloneIsNotMovedByTheShapeOfTheOther)
{
  Setting setting(100);
  const double density = 0.01;
  Signal s = setting.signal(0.3, 0, density);  // the same as the first component, and a second one with shape
  s.components = 2;
  for (std::size_t v = 0; v < setting.places.size(); ++v)
    for (std::size_t i = 0; i < radii.size(); ++i)
      s.values[v * radii.size() + i][1] = float(0.7 + 0.01 * radii[i] * std::sin(setting.places[v].x));
  s.evidence = GainSharing::each;
  const FilteredSignal each = setting.run(s, density);
  s.evidence = GainSharing::joint;
  const FilteredSignal joint = setting.run(s, density);
  const double largest_ball = std::sqrt(disc_variance::mean_curvature * density / std::pow(radii.back(), 6));
  EXPECT_LT(rms_error(setting, each, 0.3), 2 * largest_ball);
  EXPECT_GT(rms_error(setting, joint, 0.3), 10 * largest_ball);
  EXPECT_LT(each.variance[5050][0], each.variance[5050][1]);
  EXPECT_EQ(joint.variance[5050][0], joint.variance[5050][1]);
}

TEST(KernelSum, SumsToTheTotalAndIsLocal)
{
  std::vector<Vec3> places;
  for (int i = 0; i < 100; ++i) places.push_back({i * 0.37, std::sin(i * 1.0), 0});
  std::vector<std::array<double, 1>> ones(places.size(), {1.0}), single(places.size(), {0.0});
  single[0] = {1};
  Execution execution(1);
  const KernelSum pool(places, 2, execution);
  pool.splat_and_slice(single, execution);
  pool.splat_and_slice(ones, execution);
  double total = 0;
  for (const auto& row : single) total += row[0];
  EXPECT_NEAR(total, ones[0][0], 1e-6);  // the kernel is symmetric
  EXPECT_EQ(single[50][0], 0);
  EXPECT_GT(single[1][0], 0);
}

TEST(KernelSum, SumsAreTheSameBitsWithAnyNumberOfThreads)
{
  std::vector<Vec3> places;
  std::vector<std::array<double, 2>> values;
  for (int i = 0; i < 20000; ++i) {
    places.push_back({100 * std::sin(i * 0.7), 100 * std::cos(i * 1.3), 10 * std::sin(i * 2.9)});
    values.push_back({std::sin(i * 0.1), 1});
  }
  Execution alone(1), several(3);
  auto by_one = values, by_three = values;
  KernelSum(places, 8, alone).splat_and_slice(by_one, alone);
  KernelSum(places, 8, several).splat_and_slice(by_three, several);
  EXPECT_EQ(by_one, by_three);
}
