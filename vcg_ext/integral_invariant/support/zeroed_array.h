// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

#if defined(__linux__)
#include <sys/mman.h>
#endif

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
    ask_for_large_pages(size * sizeof(T));
  }
  T* data() { return elements_.get(); }
  T& operator[](std::size_t i) { return elements_[i]; }
  const T& operator[](std::size_t i) const { return elements_[i]; }

 private:
  struct Free {
    void operator()(T* block) const { std::free(block); }
  };

  void ask_for_large_pages([[maybe_unused]] std::size_t bytes)
  {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    constexpr std::uintptr_t page = std::uintptr_t(1) << 21;
    const std::uintptr_t begin = reinterpret_cast<std::uintptr_t>(elements_.get());
    const std::uintptr_t first = (begin + page - 1) / page * page, last = (begin + bytes) / page * page;
    // Without them it only takes longer.
    if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
  }

  std::unique_ptr<T[], Free> elements_;
};

}  // namespace integral_invariant
