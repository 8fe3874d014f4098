// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/multiscale/jet_fusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace integral_invariant;

namespace {

/// Places on a square lattice; the chain is off by `bias` everywhere, the fits by noise alone.
struct Setting {
  Setting(double bias, double noise)
  {
    std::mt19937 generator(9);
    std::normal_distribution<double> gauss(0, noise);
    for (int i = 0; i < 60; ++i)
      for (int j = 0; j < 60; ++j) {
        places.push_back({double(i), double(j), 0});
        chain.value.push_back({truth + bias, 0});
        chain.variance.push_back({bias * bias, bias * bias});
        fitted.values.push_back({truth + gauss(generator), 0});
        fitted.noise.push_back(noise * noise);
        fitted.error.push_back(4 * noise * noise);
      }
  }
  double mean_error() const
  {
    double sum = 0;
    for (const auto& value : chain.value) sum += std::abs(value[0] - truth);
    return sum / double(chain.value.size());
  }

  Execution execution{1};
  static constexpr double truth = 0.3;
  std::vector<Vec3> places;
  FilteredSignal chain;
  JetObservation fitted{1, GainSharing::joint, {}, {}, {}};
};

}  // namespace

TEST(VertexStep, FitsOfLittleNoiseReplaceABiasedChain)
{
  Setting setting(0.01, 1e-5);
  fuse_jets(setting.fitted, KernelSum(setting.places, 8, setting.execution), setting.chain, setting.execution);
  EXPECT_LT(setting.mean_error(), 0.01 / 20);
  EXPECT_NEAR(std::sqrt(setting.chain.variance[1000][0]), 2e-5, 1e-6);
}

TEST(VertexStep, NoisyFitsAreLeftAlone)
{
  Setting setting(0.01, 0.1);
  fuse_jets(setting.fitted, KernelSum(setting.places, 8, setting.execution), setting.chain, setting.execution);
  EXPECT_NEAR(setting.mean_error(), 0.01, 1e-12);
}

TEST(VertexStep, VerticesWithoutAFitKeepTheirValue)
{
  Setting setting(0.01, 1e-5);
  setting.fitted.noise[7] = INFINITY;
  fuse_jets(setting.fitted, KernelSum(setting.places, 8, setting.execution), setting.chain, setting.execution);
  EXPECT_EQ(setting.chain.value[7][0], Setting::truth + 0.01);
}
