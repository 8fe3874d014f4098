// SPDX-License-Identifier: GPL-3.0-or-later
// What the families show: one row a cell, and a table with one line a family.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "families/families.h"
#include "families/reference_results.h"

namespace accuracy {

struct FamilyRow {
  std::string family, shape, group;
  double level = 0;
  Metrics ours;
  double noise = 0;  ///< estimated, in average edges
  ReferenceResult constant, published;
  double seconds = 0;  ///< of ours

  /// Our error over that of the best constant radius.
  double ratio() const { return ours.mean / constant.mean; }
};

void print_family_header(std::FILE* file);
void print_family_row(const FamilyRow& row, std::FILE* file);

/// In Markdown, families in the order of the rows: geometric mean and largest of our error over the best constant
/// radius's, over the published method's, mean errors, coverage.
void print_family_table(const std::vector<FamilyRow>& rows, std::FILE* file);

}  // namespace accuracy
