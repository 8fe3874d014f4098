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

// Into the clone that calls it, and compiled for its processor.
#if defined(__GNUC__)
#define II_INLINE inline __attribute__((always_inline))
#else
#define II_INLINE inline
#endif

namespace integral_invariant {

inline constexpr std::size_t kernel_lanes = 8;

/// As many numbers, with + − · lane by lane and with a scalar, for loops that a compiler does not turn into vectors by
/// itself. Not for template arguments, which lose the alignment that all clones must agree on.
#if defined(__GNUC__)
using Lanes =
    double __attribute__((vector_size(kernel_lanes * sizeof(double)), aligned(kernel_lanes * sizeof(double))));
#else
struct alignas(kernel_lanes * sizeof(double)) Lanes {
  double lane[kernel_lanes] = {};

  double& operator[](std::size_t j) { return lane[j]; }
  double operator[](std::size_t j) const { return lane[j]; }
  template <class Operation>
  static Lanes each(const Operation& operation)
  {
    Lanes result;
    for (std::size_t j = 0; j < kernel_lanes; ++j) result[j] = operation(j);
    return result;
  }
  friend Lanes operator+(const Lanes& a, const Lanes& b)
  {
    return each([&](std::size_t j) { return a[j] + b[j]; });
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b)
  {
    return each([&](std::size_t j) { return a[j] - b[j]; });
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b)
  {
    return each([&](std::size_t j) { return a[j] * b[j]; });
  }
  friend Lanes operator*(const Lanes& a, double b)
  {
    return each([&](std::size_t j) { return a[j] * b; });
  }
  Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
  Lanes& operator-=(const Lanes& b) { return *this = *this - b; }
  Lanes& operator*=(const Lanes& b) { return *this = *this * b; }
};
#endif

/// Of a Lanes or an array.
template <class Lane>
double sum_of_lanes(const Lane& lane)
{
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

}  // namespace integral_invariant
