// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "integral_invariant/support/execution.h"
#include "integral_invariant/vec3.h"

namespace integral_invariant {

/// Weighted sums over the places around each of a set of places, in time that does not depend on how many there are:
/// values are shared out to the corners of a grid and read back from there, both trilinearly. The kernel reaches 2
/// cells and has standard deviation 0.58 cells along each axis; its largest value is under 1.
class KernelSum {
 public:
  /// Cost O(n), 16 bytes a place; the less the nearer consecutive places are.
  KernelSum(const std::vector<Vec3>& places, double cell, Execution& execution);

  /// Row v of `values` becomes Σ_u K(v, u) values[u], column by column. Cost O(n · columns), on all workers; the order
  /// of summation depends on the places alone. \throw Cancelled
  template <std::size_t columns>
  void splat_and_slice(std::vector<std::array<double, columns>>& values, Execution& execution) const
  {
    using Row = std::array<double, columns>;
    std::vector<std::array<Row, 8>> of_cell(cells_.size());
    for_each_cell(execution, [&](std::size_t cell) {
      std::array<Row, 8> sums{};
      for (const Place *place = begin(cell), *end = this->end(cell); place != end; ++place)
        for (int corner = 0; corner < 8; ++corner) {
          const double weight = weight_of(*place, corner);
          for (std::size_t c = 0; c < columns; ++c) sums[corner][c] += weight * values[place->index][c];
        }
      of_cell[cell] = sums;
    });
    std::vector<Row> nodes(node_count_);
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
      for (int corner = 0; corner < 8; ++corner)
        for (std::size_t c = 0; c < columns; ++c) nodes[cells_[cell].nodes[corner]][c] += of_cell[cell][corner][c];
    for_each_cell(execution, [&](std::size_t cell) {
      std::array<Row, 8> corners;
      for (int corner = 0; corner < 8; ++corner) corners[corner] = nodes[cells_[cell].nodes[corner]];
      for (const Place *place = begin(cell), *end = this->end(cell); place != end; ++place) {
        Row sum{};
        for (int corner = 0; corner < 8; ++corner) {
          const double weight = weight_of(*place, corner);
          for (std::size_t c = 0; c < columns; ++c) sum[c] += weight * corners[corner][c];
        }
        values[place->index] = sum;
      }
    });
  }

 private:
  struct Place {
    std::array<float, 3> fraction;  ///< where in its cell it is
    std::uint32_t index;
  };
  struct Cell {
    std::array<std::uint32_t, 8> nodes;
    std::uint32_t places_end;  ///< they begin where those of the cell before end
  };

  const Place* begin(std::size_t cell) const { return places_.data() + (cell == 0 ? 0 : cells_[cell - 1].places_end); }
  const Place* end(std::size_t cell) const { return places_.data() + cells_[cell].places_end; }

  static double weight_of(const Place& place, int corner)
  {
    const std::array<float, 3>& f = place.fraction;
    return double(corner & 1 ? f[0] : 1 - f[0]) * double(corner & 2 ? f[1] : 1 - f[1]) *
           double(corner & 4 ? f[2] : 1 - f[2]);
  }

  template <class Body>
  void for_each_cell(Execution& execution, const Body& body) const
  {
    constexpr std::size_t grain = 64;  // cells: some thousand places
    parallel_step(cells_.size(), grain, execution, [&](std::size_t begin, std::size_t end, int) {
      for (std::size_t cell = begin; cell < end; ++cell) body(cell);
    });
  }

  std::vector<Place> places_;  ///< cell by cell
  std::vector<Cell> cells_;
  std::size_t node_count_ = 0;
};

}  // namespace integral_invariant
