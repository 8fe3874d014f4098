// SPDX-License-Identifier: GPL-3.0-or-later
// Results of methods that do not change with this library's estimator, kept in a file so that a new estimator is
// compared in a minute.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "estimate.h"
#include "families/families.h"

namespace accuracy {

/// The least errors of one method on one cell over its radii, and the radii (in average edges) at which it has them.
struct ReferenceResult {
  std::string method;
  double mean = INFINITY, mean_radius = 0, direction = INFINITY, direction_radius = 0;

  void take(const Metrics& metrics, double radius);
};

/// A CSV file of reference results. A cell is known by its name, level and seed, and by the average edge of its mesh:
/// where the families have changed, the edge has, and the cell is measured anew.
class ReferenceResults {
 public:
  /// Reads `path`; a file that does not exist is empty, and an empty path keeps nothing. \throw std::runtime_error
  /// where a line is damaged, or results cannot be written
  explicit ReferenceResults(const std::string& path);

  /// All results of the cell, empty if there are none.
  std::vector<ReferenceResult> find(const FamilyCell& cell, double edge) const;
  /// Adds all results of a cell at once.
  void add(const FamilyCell& cell, double edge, const std::vector<ReferenceResult>& results);

 private:
  struct Row {
    std::string cell;
    double level;
    std::uint32_t seed;
    double edge;
    ReferenceResult result;
  };

  void write(const Row& row) const;

  std::string path_;
  std::vector<Row> rows_;
};

}  // namespace accuracy
