// SPDX-License-Identifier: GPL-3.0-or-later
// Where the system has no more threads to give, fewer do the work, with the same bits.
#include <gtest/gtest.h>

#include "integral_invariant/curvature.h"
#include "integral_invariant/error.h"
#include "support/failing_threads.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

Result curvature(int threads)
{
  static const TriangleMesh mesh = with_normal_noise(torus(2, 0.6, 100, 30), 0.005);
  Parameters parameters;
  parameters.threads = threads;
  return compute_curvature(mesh, parameters, {});
}

}  // namespace

TEST(ThreadsThatCannotBeHad, FewerGiveTheSameBits)
{
  const Result one = curvature(1);
  for (const int available : {0, 1, 7}) {
    const ThreadsRunOut limit(available);
    const Result result = curvature(4);
    EXPECT_GT(limit.refused(), 0);
    EXPECT_EQ(result.kappa_max, one.kappa_max);
    EXPECT_EQ(result.kappa_min, one.kappa_min);
    EXPECT_EQ(result.standard_error, one.standard_error);
    EXPECT_TRUE(result.dir_max == one.dir_max && result.normal == one.normal);
  }
}

TEST(ThreadsThatCannotBeHad, AFailureOfAWorkerAndACancelStillReachTheCaller)
{
  for (const int available : {0, 1}) {
    const ThreadsRunOut limit(available);
    Execution execution(4);
    const RangeBody fails = [](std::size_t begin, std::size_t, int) {
      if (begin == 500) throw std::bad_alloc();
    };
    EXPECT_THROW(parallel_for(1000, 1, execution, fails), std::bad_alloc);
    Execution cancelled(4, [](int, const char*) { return false; });
    EXPECT_THROW(parallel_for(1000, 1, cancelled, [](std::size_t, std::size_t, int) {}), Cancelled);
  }
}
