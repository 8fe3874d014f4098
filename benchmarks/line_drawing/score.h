// SPDX-License-Identifier: GPL-3.0-or-later
// How drawn lines compare with the exact ones.
#pragma once

#include <vector>

#include "exact_lines.h"

namespace line_benchmark {

struct Score {
  double precision = 0;     ///< share of the drawn length that is within the tolerance of an exact line
  double recall = 0;        ///< share of the exact length that is within the tolerance of a drawn line
  double length_ratio = 0;  ///< drawn over exact
  double drawn = 0, exact = 0;
  double f() const { return precision + recall > 0 ? 2 * precision * recall / (precision + recall) : 0; }
};

/// Both in the same unit, as the tolerance is.
Score score(const std::vector<ExactSegment>& exact, const std::vector<ExactSegment>& drawn, double tolerance);

}  // namespace line_benchmark
