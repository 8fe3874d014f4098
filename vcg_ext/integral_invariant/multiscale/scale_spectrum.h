// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: how much neighbouring scales differ, place by place.
#pragma once

#include <array>
#include <vector>

#include "integral_invariant/ball_curvature/tensor_field.h"
#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// Fourth moment of Gaussian-like values over the square of their second, so scaled that Gaussian values have 3.
class Kurtosis {
 public:
  /// \param square mean square of three components
  void add(double square)
  {
    fourth_ += square * square;
    second_ += square;
    ++count_;
  }
  double value() const
  {
    constexpr double three_components = 9.0 / 5;
    return count_ > 0 ? three_components * fourth_ * double(count_) / (second_ * second_) : 0;
  }

 private:
  double fourth_ = 0, second_ = 0;
  std::size_t count_ = 0;
};

/// The energies of the bands, which are the differences between the tensors of neighbouring scales, the finest first.
class ScaleSpectrum {
 public:
  static constexpr std::size_t most_bands = 8;
  static constexpr std::size_t place_stride = 64;  ///< a place is every 64th vertex, and stands for these

  /// At one place, a neighbourhood's mean squares and how many independent values they come from.
  struct Place {
    std::array<double, most_bands> energy{}, freedom{};
  };

  /// \param tensors offset-free, of increasing radii. Cost O(n · scales), about 3 µs a vertex.
  ScaleSpectrum(const Surface& surface, const TensorField& tensors, Execution& execution);

  std::size_t bands() const { return bands_; }
  const std::vector<Place>& places() const { return places_; }
  /// Of band i over the level of a close neighbourhood, which takes out what differs from place to place; and over that
  /// of a wide one, which does not.
  double close_kurtosis(std::size_t band) const { return close_[band].value(); }
  double wide_kurtosis(std::size_t band) const { return wide_[band].value(); }

 private:
  using Sums = std::vector<std::array<double, 2>>;
  void measure(std::size_t band, std::vector<double>& squares, Sums& sums);
  void add_energies(std::size_t band, double cell, const std::vector<double>& squares, Sums& sums);
  Kurtosis kurtosis_within(double cell, const std::vector<double>& squares, Sums& sums);
  double triangulation_error(std::size_t v) const;
  std::size_t vertex_of(std::size_t place) const;

  const Surface& surface_;
  const TensorField& tensors_;
  Execution& execution_;
  std::size_t bands_ = 0;
  std::vector<Place> places_;
  std::array<Kurtosis, most_bands> close_, wide_;
};

}  // namespace integral_invariant
