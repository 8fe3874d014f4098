// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/failing_threads.h"

#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cerrno>
#include <limits>

namespace {

std::atomic<int> left{std::numeric_limits<int>::max()}, refused_threads{0};

}  // namespace

// Visible to the C++ library, which starts the threads.
extern "C" __attribute__((visibility("default"))) int pthread_create(pthread_t* thread,
                                                                     const pthread_attr_t* attributes,
                                                                     void* (*start)(void*), void* argument)
{
  if (left-- <= 0) {
    ++refused_threads;
    return EAGAIN;
  }
  using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  static const Create create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
  return create(thread, attributes, start, argument);
}

namespace test_support {

ThreadsRunOut::ThreadsRunOut(int threads)
{
  left = threads;
  refused_threads = 0;
}

ThreadsRunOut::~ThreadsRunOut() { left = std::numeric_limits<int>::max(); }

int ThreadsRunOut::refused() const { return refused_threads; }

}  // namespace test_support
