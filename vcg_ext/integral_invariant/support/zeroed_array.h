// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

#include "integral_invariant/support/large_pages.h"

namespace integral_invariant {

/// Elements whose bytes are all zero. A large array takes memory only as it is written, so that the threads that fill
/// it share the work of its pages; where the system has large pages, it has few of them. \throw std::bad_alloc
template <class T>
class ZeroedArray {
  static_assert(std::is_trivially_copyable<T>::value, "zero bytes must be a value");

 public:
  explicit ZeroedArray(std::size_t size) : elements_(static_cast<T*>(std::calloc(size ? size : 1, sizeof(T))))
  {
    if (!elements_) throw std::bad_alloc();
    ask_for_large_pages(elements_.get(), size * sizeof(T));
  }
  T* data() { return elements_.get(); }
  T& operator[](std::size_t i) { return elements_[i]; }
  const T& operator[](std::size_t i) const { return elements_[i]; }

 private:
  struct Free {
    void operator()(T* block) const { std::free(block); }
  };

  std::unique_ptr<T[], Free> elements_;
};

}  // namespace integral_invariant
