// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/failing_allocation.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>

namespace {

constexpr long never = std::numeric_limits<long>::max();
std::atomic<long> left{never}, live{0};

void* allocate(std::size_t size, std::size_t alignment)
{
  if (left.load() != never && left.fetch_sub(1) <= 1) throw std::bad_alloc();
  void* const block = alignment > alignof(std::max_align_t)
                          ? std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)
                          : std::malloc(size ? size : 1);
  if (!block) throw std::bad_alloc();
  ++live;
  return block;
}

void release(void* block) noexcept
{
  if (block) --live;
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size, 1); }
void* operator new[](std::size_t size) { return allocate(size, 1); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  try {
    return allocate(size, 1);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void* operator new(std::size_t size, std::align_val_t alignment) { return allocate(size, std::size_t(alignment)); }
void* operator new[](std::size_t size, std::align_val_t alignment) { return allocate(size, std::size_t(alignment)); }
void operator delete(void* block) noexcept { release(block); }
void operator delete[](void* block) noexcept { release(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept { release(block); }

namespace test_support {

MemoryRunsOut::MemoryRunsOut(long at_allocation) { left = at_allocation; }
MemoryRunsOut::~MemoryRunsOut() { left = never; }
long live_blocks() { return live; }

}  // namespace test_support
