// SPDX-License-Identifier: GPL-3.0-or-later
// Threads, progress, cancelling and timing. The only file that starts threads.
#include "integral_invariant/support/execution.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

#include "integral_invariant/error.h"

namespace integral_invariant {

namespace {

constexpr auto report_interval = std::chrono::milliseconds(60);
constexpr auto poll_interval = std::chrono::milliseconds(30);

/// Blocks handed out in order to whoever asks, until none is left or somebody failed.
class BlockQueue {
 public:
  BlockQueue(std::size_t count, std::size_t grain) : count_(count), grain_(grain) {}

  void work(const RangeBody& body, int worker)
  {
    try {
      for (std::size_t begin; !stop_ && (begin = next_.fetch_add(grain_)) < count_;) {
        const std::size_t end = std::min(begin + grain_, count_);
        body(begin, end, worker);
        done_ += end - begin;
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      stop_ = true;
    }
  }

  double fraction() const { return double(done_) / double(count_); }
  void stop() { stop_ = true; }
  std::exception_ptr error() const { return error_; }

 private:
  const std::size_t count_, grain_;
  std::atomic<std::size_t> next_{0}, done_{0};
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::exception_ptr error_;
};

/// Workers that are joined on every way out.
class ThreadGroup {
 public:
  explicit ThreadGroup(BlockQueue& queue) : queue_(queue) {}
  ~ThreadGroup()
  {
    queue_.stop();
    for (std::thread& thread : threads_) thread.join();
  }

  /// Starts up to `size` workers, fewer where the system has no more threads to give; says how many.
  int start(int size, const RangeBody& body)
  {
    threads_.reserve(std::size_t(size));
    for (int worker = 0; worker < size; ++worker) {
      change_active(+1);
      try {
        threads_.emplace_back([this, &body, worker] { run(body, worker); });
      } catch (const std::system_error&) {
        change_active(-1);
        return worker;
      } catch (...) {
        change_active(-1);
        throw;
      }
    }
    return size;
  }

  /// True when all have ended, false after `duration`.
  template <class Duration>
  bool wait_for(Duration duration)
  {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, duration, [this] { return active_ == 0; });
  }

 private:
  void change_active(int by)
  {
    const std::lock_guard lock(mutex_);
    active_ += by;
  }

  void run(const RangeBody& body, int worker)
  {
    queue_.work(body, worker);
    const std::lock_guard lock(mutex_);
    if (--active_ == 0) ended_.notify_all();
  }

  BlockQueue& queue_;
  std::mutex mutex_;
  std::condition_variable ended_;
  int active_ = 0;
  std::vector<std::thread> threads_;
};

}  // namespace

Execution::Execution(int threads, ProgressCallback callback)
    : threads_(threads > 0 ? threads : std::max(1, int(std::thread::hardware_concurrency()))),
      callback_(std::move(callback))
{
}

void Execution::begin_stage(const std::string& stage, int end_percent)
{
  end_stage();
  stage_ = stage;
  first_percent_ = end_percent_;
  end_percent_ = end_percent;
  stage_start_ = Clock::now();
  last_report_ = {};
  report(0);
}

void Execution::end_stage()
{
  if (stage_.empty()) return;
  stage_times_.push_back({stage_, std::chrono::duration<double>(Clock::now() - stage_start_).count()});
  stage_.clear();
}

void Execution::finish() { end_stage(); }

void Execution::report(double fraction)
{
  fraction_ = fraction;
  if (!callback_) return;
  const auto now = Clock::now();
  if (now - last_report_ < report_interval) return;
  last_report_ = now;
  const double percent = first_percent_ + (end_percent_ - first_percent_) * std::clamp(fraction, 0.0, 1.0);
  if (!callback_(int(percent), stage_.c_str())) throw Cancelled();
}

void parallel_for(std::size_t count, std::size_t grain, Execution& execution, const RangeBody& body, double from,
                  double to)
{
  if (count == 0) return;
  grain = std::max<std::size_t>(grain, 1);
  const std::size_t blocks = (count + grain - 1) / grain;
  const auto serial = [&] {
    for (std::size_t begin = 0; begin < count; begin += grain) {
      body(begin, std::min(begin + grain, count), 0);
      execution.report(from + (to - from) * double(std::min(begin + grain, count)) / double(count));
    }
  };
  if (blocks == 1 || execution.threads() == 1) return serial();
  BlockQueue queue(count, grain);
  {
    ThreadGroup crew(queue);
    if (crew.start(int(std::min<std::size_t>(blocks, std::size_t(execution.threads()))), body) == 0) return serial();
    while (!crew.wait_for(poll_interval)) execution.report(from + (to - from) * queue.fraction());
  }
  if (queue.error()) std::rethrow_exception(queue.error());
  execution.report(to);
}

}  // namespace integral_invariant
