// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that runs out when a test says so: replaces the global operator new of the programs that it is linked to.
#pragma once

#include <new>

namespace test_support {

/// From here to the end of its scope the n-th allocation by operator new (from 1), and all after it, throw
/// std::bad_alloc.
class MemoryRunsOut {
 public:
  explicit MemoryRunsOut(long at_allocation);
  ~MemoryRunsOut();
};

/// Blocks that operator new has given and operator delete has not taken back.
long live_blocks();

/// Whether the run of `action` on memory that ends with the n-th allocation was refused with std::bad_alloc; any other
/// exception passes on.
template <class Action>
bool runs_out_of_memory(long at_allocation, const Action& action)
{
  const MemoryRunsOut limit(at_allocation);
  try {
    action();
    return false;
  } catch (const std::bad_alloc&) {
    return true;
  }
}

}  // namespace test_support
