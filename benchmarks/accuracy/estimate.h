// SPDX-License-Identifier: GPL-3.0-or-later
// An estimate at a vertex, and the error of many of them.
#pragma once

#include <vector>

#include "truth.h"

namespace accuracy {

struct Estimate {
  double kappa_max = 0, kappa_min = 0;  ///< 1/L, positive where convex
  Vec3 dir_max;                         ///< of any length; zero if there is none
  double standard_error = 0;            ///< of either κ, 1/L; 0 if not given
};

/// The pair as (larger, smaller) with the direction of the larger; values that are not finite count as zero.
Estimate ordered(double first, double second, const Vec3& first_direction, const Vec3& second_direction);

/// Errors of κ_max and κ_min together, relative to the truth's reference, over the judged vertices.
struct Metrics {
  std::size_t vertices = 0;
  double mean = 0, rms = 0, median = 0, p95 = 0, p99 = 0;
  double direction = 0;                   ///< degrees, mean weighted by κ_max − κ_min; 0 where that is 0 everywhere
  double within_tenth = 0;                ///< share of κ better than 10 %
  double within_one = 0, within_two = 0;  ///< share of errors under one and two standard errors
};

/// \param estimates one for each vertex of `truth.judged`, in that order
Metrics compare(const TruthMesh& truth, const std::vector<Estimate>& estimates);

}  // namespace accuracy
