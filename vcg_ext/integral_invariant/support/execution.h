// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "integral_invariant/support/large_pages.h"

namespace integral_invariant {

/// Receives the percentage done (0 to 100) and the name of the stage; false asks to stop.
using ProgressCallback = std::function<bool(int percent, const char* stage)>;

struct StageTime {
  std::string stage;
  double seconds;
};

/// One run of the pipeline as its stages see it: threads, progress, cancelling and timing in one place.
///
/// The callback is called from the thread that owns the Execution only, at most about ten times a second.
/// When it returns false, the next check throws Cancelled.
class Execution {
 public:
  /// \p threads how many workers parallel_for uses; 0 = as many as the machine has.
  explicit Execution(int threads = 0, ProgressCallback callback = {});

  int threads() const { return threads_; }

  /// Starts a stage and ends the one before; it covers the progress bar from where that one ended to `end_percent`.
  void begin_stage(const std::string& stage, int end_percent);
  /// Ends the last stage.
  void finish();
  /// Seconds per stage, in the order in which they ran.
  const std::vector<StageTime>& stage_times() const { return stage_times_; }

  /// Tells the callback what fraction (0 to 1) of the stage is done. Owner thread only. \throw Cancelled
  void report(double fraction);
  /// The fraction last told.
  double fraction() const { return fraction_; }
  /// Asks the callback whether to go on, at the fraction last told. Owner thread only. \throw Cancelled
  void check() { report(fraction_); }

 private:
  using Clock = std::chrono::steady_clock;

  void end_stage();

  int threads_;
  ProgressCallback callback_;
  std::string stage_;
  double first_percent_ = 0, end_percent_ = 0, fraction_ = 0;
  Clock::time_point stage_start_{}, last_report_{};
  std::vector<StageTime> stage_times_;
};

/// Work on the indices [begin, end); `worker` in [0, threads) names the calling worker, for its scratch memory.
using RangeBody = std::function<void(std::size_t begin, std::size_t end, int worker)>;

/// Calls `body` on consecutive blocks of at most `grain` indices that cover [0, count), on all workers; which worker
/// takes which block is not defined, so results must depend on the index alone. Serial when one block is enough;
/// on fewer workers, down to the calling thread, where the system has no more threads to give.
/// Reports progress meanwhile: the stage's fraction runs from `from` to `to`.
/// \throw the first exception thrown by a body; Cancelled. All workers have ended by then.
void parallel_for(std::size_t count, std::size_t grain, Execution& execution, const RangeBody& body, double from = 0,
                  double to = 1);
/// The same for one step of a stage: progress stays where it is.
inline void parallel_step(std::size_t count, std::size_t grain, Execution& execution, const RangeBody& body)
{
  parallel_for(count, grain, execution, body, execution.fraction(), execution.fraction());
}

/// A step that calls `body` with every index in [0, count).
template <class Body>
void for_each_index(std::size_t count, Execution& execution, const Body& body)
{
  constexpr std::size_t grain = 4096;
  parallel_step(count, grain, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

/// Calls `body` with every index in [0, count), in order, on the calling thread; asks every now and then whether to go
/// on. \throw Cancelled
template <class Body>
void for_each_in_order(std::size_t count, Execution& execution, const Body& body)
{
  constexpr std::size_t block = 65536;  // a few milliseconds' work
  for (std::size_t begin = 0; begin < count; begin += block) {
    const std::size_t end = std::min(begin + block, count);
    for (std::size_t i = begin; i < end; ++i) body(i);
    execution.check();
  }
}

/// Resizes to `size`, new elements being `value`; asks meanwhile, for the system takes a second to hand out a few
/// gigabytes. \throw Cancelled
template <class T>
void resize_in_steps(std::vector<T>& values, std::size_t size, Execution& execution, const T& value = {})
{
  constexpr std::size_t block = (std::size_t(1) << 23) / sizeof(T) + 1;
  reserve_large(values, size);
  while (values.size() < size) {
    values.resize(std::min(size, values.size() + block), value);
    execution.check();
  }
}

}  // namespace integral_invariant
