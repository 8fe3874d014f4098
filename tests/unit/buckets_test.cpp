// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/support/buckets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include "integral_invariant/error.h"

using namespace integral_invariant;

namespace {

constexpr std::size_t count = 200000;

/// Stops at the first call after `calls` of them.
Execution stopping_after(int calls)
{
  Execution execution(1, [calls](int, const char*) mutable { return calls-- > 0; });
  execution.begin_stage("test", 100);  // the first call
  return execution;
}

}  // namespace

TEST(Buckets, HoldWhatHasTheirKeyInTheOrderInWhichItCame)
{
  Execution execution(1);
  const Buckets<int> buckets = in_buckets<int>(10, 4, execution, [](std::size_t i, const auto& put) {
    if (i == 5) return;
    put(i % 3, int(i));
    put(i % 3, -int(i));
  });
  const std::vector<std::vector<int>> expected = {
      {0, 0, 3, -3, 6, -6, 9, -9}, {1, -1, 4, -4, 7, -7}, {2, -2, 8, -8}, {}};
  ASSERT_EQ(buckets.count(), expected.size());
  for (std::size_t key = 0; key < expected.size(); ++key)
    EXPECT_EQ(std::vector<int>(buckets.begin(key), buckets.end(key)), expected[key]) << key;
}

TEST(Buckets, OfNothingAreEmpty)
{
  Execution execution(1);
  const auto nothing = [](std::size_t, const auto&) {};
  EXPECT_EQ(in_buckets<int>(0, 0, execution, nothing).count(), 0u);
  const Buckets<int> empty = in_buckets<int>(0, 3, execution, nothing);
  for (std::size_t key = 0; key < 3; ++key) EXPECT_EQ(empty.begin(key), empty.end(key));
}

TEST(ForEachInOrder, VisitsAllAndStops)
{
  Execution patient(1);
  std::size_t next = 0;
  for_each_in_order(count, patient, [&](std::size_t i) { EXPECT_EQ(i, next++); });
  EXPECT_EQ(next, count);

  Execution hurried = stopping_after(1);
  // Slow enough for the callback, which is not asked at every chance.
  const auto wait = [](std::size_t i) {
    if (i % 32768 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  };
  EXPECT_THROW(for_each_in_order(count, hurried, wait), Cancelled);
}

TEST(ResizeInSteps, GivesZerosAndKeepsWhatIsThere)
{
  Execution execution(1);
  std::vector<double> values{1, 2};
  constexpr std::size_t many = 10000000;  // several steps
  resize_in_steps(values, many, execution);
  ASSERT_EQ(values.size(), many);
  EXPECT_EQ(values[1], 2);
  EXPECT_TRUE(std::all_of(values.begin() + 2, values.end(), [](double v) { return v == 0; }));
}
