// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: what a run tells people about itself.
#pragma once

#include <string>
#include <vector>

#include "integral_invariant/result.h"
#include "quality.h"

namespace integral_invariant::filter {

/// What was measured and how, one line an entry: mesh, scales, engine, convergence.
std::vector<std::string> run_lines(const Result& result);

/// What is wrong with the mesh: one line, or none.
std::vector<std::string> defect_lines(const Result& result);

/// The last line: seconds of the whole run and of its stages.
std::string time_line(const Result& result);
double total_seconds(const Result& result);

/// Extremes and percentiles of the quality; `quantity` says of what, and ends with a space, or is empty.
std::string quality_line(const std::string& quantity, const Statistics& statistics);

/// Four significant digits, as the log writes numbers.
std::string short_number(double value);

/// Vertices whose ball had less than half of its surface.
std::size_t low_confidence_count(const Result& result);

}  // namespace integral_invariant::filter
