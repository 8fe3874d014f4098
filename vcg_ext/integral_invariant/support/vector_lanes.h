// SPDX-License-Identifier: GPL-3.0-or-later
// What inner loops on arrays share: every one works in groups of a fixed number of lanes, in files that are compiled
// without contraction to fused multiply-add, so that all instruction sets give the same bits.
#pragma once

#include <cstddef>

// One binary for old and new processors: the loader picks the clone, before ThreadSanitizer is ready for it. Elsewhere
// the compiler's default target is used.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_THREAD__)
#define II_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define II_VECTOR_CLONES
#endif

namespace integral_invariant {

inline constexpr std::size_t kernel_lanes = 8;

inline double sum_of_lanes(const double* lane)
{
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

}  // namespace integral_invariant
