// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace integral_invariant {

/// Asks the system to back `bytes` from `begin` on, not yet written, with pages of 2 MiB: the fewer pages, the less
/// time to hand them out and to take them back. Where it has none, everything only takes longer.
inline void ask_for_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t page = std::uintptr_t(1) << 21;
  const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = (address + page - 1) / page * page, last = (address + bytes) / page * page;
  if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
}

/// Room for `size` elements, in large pages.
template <class T>
void reserve_large(std::vector<T>& values, std::size_t size)
{
  if (values.capacity() >= size) return;
  values.reserve(size);
  if (values.empty()) ask_for_large_pages(values.data(), size * sizeof(T));
}

}  // namespace integral_invariant
