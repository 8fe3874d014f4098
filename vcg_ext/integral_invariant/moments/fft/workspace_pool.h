// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1, FFT engine: memory of the tiles in work, lent to workers so that more threads do not take more of it.
#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "integral_invariant/moments/fft/fftw_plan.h"

namespace integral_invariant {

/// A tile in work: its transform and what is read at its vertices.
struct Workspace {
  explicit Workspace(const std::array<int, 3>& size) : transform(size), product(size) {}
  FftBuffer transform, product;
  std::vector<float> values;  ///< moment_count per vertex of the tile
};

/// As many workspaces as memory allows; whoever needs one waits for it.
class WorkspacePool {
 public:
  WorkspacePool(const std::array<int, 3>& size, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i) {
      all_.push_back(std::make_unique<Workspace>(size));
      free_.push_back(all_.back().get());
    }
  }

  /// Calls `use` with a workspace that no other thread has.
  template <class Use>
  void with_workspace(const Use& use)
  {
    Workspace* workspace = acquire();
    try {
      use(*workspace);
    } catch (...) {
      release(workspace);
      throw;
    }
    release(workspace);
  }

 private:
  Workspace* acquire()
  {
    std::unique_lock lock(mutex_);
    freed_.wait(lock, [this] { return !free_.empty(); });
    Workspace* workspace = free_.back();
    free_.pop_back();
    return workspace;
  }
  void release(Workspace* workspace)
  {
    const std::lock_guard lock(mutex_);
    free_.push_back(workspace);
    freed_.notify_one();
  }

  std::vector<std::unique_ptr<Workspace>> all_;
  std::vector<Workspace*> free_;
  std::mutex mutex_;
  std::condition_variable freed_;
};

}  // namespace integral_invariant
