// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/support/execution.h"

#include <gtest/gtest.h>

#include <thread>

#include "integral_invariant/error.h"

using namespace integral_invariant;

TEST(ParallelFor, VisitsEveryIndexOnce)
{
  for (const int threads : {1, 2, 5}) {
    Execution execution(threads);
    std::vector<int> visits(10007, 0);
    parallel_for(visits.size(), 64, execution, [&](std::size_t begin, std::size_t end, int worker) {
      EXPECT_GE(worker, 0);
      EXPECT_LT(worker, threads);
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), 10007);
  }
}

TEST(ParallelFor, PassesOnAnExceptionOfAWorker)
{
  for (const int threads : {1, 3}) {
    Execution execution(threads);
    EXPECT_THROW(parallel_for(1000, 1, execution,
                              [](std::size_t begin, std::size_t, int) {
                                if (begin == 500) throw std::bad_alloc();
                              }),
                 std::bad_alloc);
  }
}

TEST(ParallelFor, StopsSoonWhenTheCallbackReturnsFalse)
{
  using Clock = std::chrono::steady_clock;
  for (const int threads : {1, 2}) {
    const auto start = Clock::now();
    Execution execution(threads,
                        [&](int, const char*) { return Clock::now() - start < std::chrono::milliseconds(150); });
    const RangeBody sleep = [](std::size_t, std::size_t, int) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    };
    EXPECT_THROW(
        {
          execution.begin_stage("sleeping", 100);
          parallel_for(10000, 1, execution, sleep);
        },
        Cancelled);
    // Asked to stop at 150 ms; the next report is at most 100 ms later, the workers end within a block.
    EXPECT_LT(Clock::now() - start, std::chrono::milliseconds(350));
  }
}

TEST(Execution, CallsBackFromItsOwnThreadInOrderAndSeldom)
{
  const auto owner = std::this_thread::get_id();
  std::vector<int> percents;
  Execution execution(2, [&](int percent, const char*) {
    EXPECT_EQ(std::this_thread::get_id(), owner);
    percents.push_back(percent);
    return true;
  });
  execution.begin_stage("first", 60);
  parallel_for(60, 1, execution,
               [](std::size_t, std::size_t, int) { std::this_thread::sleep_for(std::chrono::milliseconds(10)); });
  execution.begin_stage("second", 100);
  execution.finish();
  EXPECT_TRUE(std::is_sorted(percents.begin(), percents.end()));
  EXPECT_LE(percents.size(), 8u);
  ASSERT_EQ(execution.stage_times().size(), 2u);
  EXPECT_EQ(execution.stage_times()[0].stage, "first");
  EXPECT_NEAR(execution.stage_times()[0].seconds, 0.3, 0.25);
}
