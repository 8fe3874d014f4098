// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace integral_invariant {

/// Bytes that a run may take: `limit_mb` MiB, or half of the machine's memory where that is 0.
std::size_t memory_limit_bytes(std::size_t limit_mb);

/// Such as "1.5 GiB" or "320 MiB".
std::string readable_bytes(double bytes);

/// \throw MemoryError where `bytes` exceed the limit; `what` needs them, `advice` says what to change.
void require_memory(double bytes, std::size_t limit_mb, const std::string& what, const std::string& advice);

}  // namespace integral_invariant
