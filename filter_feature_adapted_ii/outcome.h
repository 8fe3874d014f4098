// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: everything that a run of the filter leaves, complete before a mesh is touched.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "integral_invariant/result.h"
#include "parameter_table.h"
#include "quality.h"

namespace integral_invariant::filter {

/// One number a vertex under the name that hosts and files know it by.
struct NamedValues {
  std::string name;
  std::vector<float> values;
};

struct Outcome {
  Result result;
  Quantity quantity = Quantity::mean;
  std::vector<double> quality;  ///< of every vertex
  Statistics quality_statistics;
  bool colorize = true;
  ColorRange colors;
  std::string exported;  ///< the file that was written; empty: none

  Color color(std::size_t vertex) const { return color_of(quality[vertex], colors, quantity); }
};

Outcome make_outcome(Result result, const OutputOptions& options);

/// The log: vertices, scales, engine, convergence, quality, defects of the mesh, seconds; one line an entry.
std::vector<std::string> summary_lines(const Outcome& outcome);

/// The same for programs, as (name, number or text): vertices, triangles, scales, median_radius, converged,
/// low_confidence, seconds, ..., and for each quantity <key>_min, _p5, _median, _p95, _max.
using SummaryValue = std::variant<int, double, std::string>;
std::vector<std::pair<std::string, SummaryValue>> summary_values(const Outcome& outcome);

/// The part of the log that says what was measured and how: mesh, scales, engine, convergence, defects; and the last
/// line.
std::vector<std::string> run_lines(const Result& result);
std::string time_line(const Result& result);

/// Four significant digits, as the log writes numbers.
std::string short_number(double value);

/// Vertices whose ball had less than half of its surface.
std::size_t low_confidence_count(const Result& result);

}  // namespace integral_invariant::filter
