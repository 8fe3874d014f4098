// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace integral_invariant {

/// Sums of N columns of terms, bit by bit the same whatever the order of the terms. Each term is split into two parts,
/// multiples of a coarse and of a fine step, such that no sum of up to `count` of them is ever rounded; what is left
/// of it is lost, at most 2^-103 count² times the largest term. Source: Demmel and Nguyen, Fast reproducible
/// floating-point summation, 2013.
template <std::size_t N>
class OrderlessSums {
 public:
  /// \pre no absolute value of a term is over `largest`
  OrderlessSums(double largest, std::size_t count)
      : coarse_(rounder(2 * largest * double(count + 1))),
        fine_(rounder(2 * std::ldexp(coarse_, -digits) * double(count + 1)))
  {
  }

  void add(const std::array<double, N>& terms)
  {
    for (std::size_t i = 0; i < N; ++i) {
      const double coarse = (terms[i] + coarse_) - coarse_;
      coarse_sums_[i] += coarse;
      fine_sums_[i] += ((terms[i] - coarse) + fine_) - fine_;
    }
  }

  OrderlessSums& operator+=(const OrderlessSums& other)
  {
    for (std::size_t i = 0; i < N; ++i) {
      coarse_sums_[i] += other.coarse_sums_[i];
      fine_sums_[i] += other.fine_sums_[i];
    }
    return *this;
  }

  std::array<double, N> values() const
  {
    std::array<double, N> sums;
    for (std::size_t i = 0; i < N; ++i) sums[i] = coarse_sums_[i] + fine_sums_[i];
    return sums;
  }

 private:
  static constexpr int digits = 52;  ///< binary, after the first, of a double

  /// What rounds a term to a multiple of 2^-52 times a power of two that is at least `bound`, when it is added to it
  /// and taken off again.
  static double rounder(double bound) { return std::ldexp(1.5, std::ilogb(bound) + 1); }

  double coarse_, fine_;
  std::array<double, N> coarse_sums_{}, fine_sums_{};
};

}  // namespace integral_invariant
