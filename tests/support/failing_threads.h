// SPDX-License-Identifier: GPL-3.0-or-later
// Threads that cannot be had: replaces pthread_create of the programs that it is linked to.
#pragma once

namespace test_support {

/// From here to the end of its scope only `threads` more threads can be started, as where a limit of the system is met.
class ThreadsRunOut {
 public:
  explicit ThreadsRunOut(int threads);
  ~ThreadsRunOut();

  /// How many were asked for in vain.
  int refused() const;
};

}  // namespace test_support
