// SPDX-License-Identifier: GPL-3.0-or-later
// Runs on several threads, small enough for a sanitizer: the same bits as on one, and failures of workers reach the
// caller.
#include <gtest/gtest.h>

#include <atomic>

#include "integral_invariant/curvature.h"
#include "integral_invariant/features/crest_lines.h"
#include "integral_invariant/features/curvature_lines.h"
#include "integral_invariant/moments/engine.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

const TriangleMesh& sample()
{
  static const TriangleMesh mesh = with_normal_noise(torus(2, 0.6, 100, 30), 0.005);
  return mesh;
}

struct Case {
  EngineKind engine;
  RadiusChoice choice;
};

class Threads : public testing::TestWithParam<Case> {
 protected:
  Parameters parameters(int threads) const
  {
    Parameters p;
    p.engine = GetParam().engine;
    p.radius_choice = GetParam().choice;
    p.scales = 4;
    p.threads = threads;
    return p;
  }
};

struct WorkerFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Runs, Threads,
                         testing::Values(Case{EngineKind::surface_integral, RadiusChoice::statistical},
                                         Case{EngineKind::surface_integral, RadiusChoice::feature_adapted},
                                         Case{EngineKind::volume_fft, RadiusChoice::statistical},
                                         Case{EngineKind::volume_fft, RadiusChoice::feature_adapted}));

TEST_P(Threads, GiveTheSameBitsAsOne)
{
  const Result one = compute_curvature(sample(), parameters(1), {}),
               four = compute_curvature(sample(), parameters(4), {});
  EXPECT_EQ(one.kappa_max, four.kappa_max);
  EXPECT_EQ(one.kappa_min, four.kappa_min);
  EXPECT_EQ(one.radius, four.radius);
  EXPECT_EQ(one.standard_error, four.standard_error);
  EXPECT_EQ(one.confidence, four.confidence);
  EXPECT_TRUE(one.dir_max == four.dir_max && one.dir_min == four.dir_min && one.normal == four.normal);
}

TEST_P(Threads, AnExceptionInAWorkerReachesTheCaller)
{
  const Surface surface(sample());
  Execution execution(4);
  const auto engine = make_moment_engine(surface, parameters(4), execution);
  std::atomic<int> calls{0};
  try {
    engine->evaluate(
        {2, 4},
        [&](std::size_t, int, const BallMoments&) {
          if (++calls == 1000) throw WorkerFailed("the thousandth ball");
        },
        execution);
    FAIL() << "nothing was thrown";
  } catch (const WorkerFailed& error) {
    EXPECT_STREQ(error.what(), "the thousandth ball");
  }
}

TEST_P(Threads, AnExceptionInTheCallbackReachesTheCaller)
{
  int calls = 0;
  EXPECT_THROW(compute_curvature(sample(), parameters(4),
                                 [&](int, const char*) -> bool {
                                   if (++calls == 3) throw WorkerFailed("callback");
                                   return true;
                                 }),
               WorkerFailed);
}

TEST(ThreadsOfFeatures, GiveTheSameLinesAsOne)
{
  const Result result = compute_curvature(sample(), {}, {});
  const Surface surface(sample());
  Execution one(1), four(4);
  const auto a = find_crest_lines(surface, curvature_field(result), {}, one);
  const auto b = find_crest_lines(surface, curvature_field(result), {}, four);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].strength, b[i].strength);
}
