// SPDX-License-Identifier: GPL-3.0-or-later
// Principal directions as segments, and the seeding of lines of curvature.
#include "integral_invariant/features/curvature_lines.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <string>

#include "integral_invariant/error.h"
#include "integral_invariant/features/line_tracer.h"
#include "integral_invariant/features/point_grid.h"
#include "integral_invariant/parameters.h"
#include "integral_invariant/support/memory.h"

namespace integral_invariant {

namespace {

constexpr double automatic_spacing = 3;    ///< ē
constexpr double automatic_segment = 0.8;  ///< of the spacing
constexpr double automatic_minimum = 2;    ///< of the spacing
/// A seed may be a little nearer than the spacing: space is shorter than the way over a bent surface.
constexpr double seed_tolerance = 0.85;

double spacing_of(const DirectionParameters& p, double unit)
{
  return p.spacing > 0 ? p.spacing / unit : automatic_spacing;
}

void require_lengths(const DirectionParameters& p, double unit)
{
  constexpr double smallest = 1e-3, largest = 1e6;  // ē
  const std::pair<const char*, double> lengths[] = {{"spacing", p.spacing}, {"segment_length", p.segment_length}};
  for (const auto& [name, length] : lengths)
    if (length != 0 && !(length / unit >= smallest && length / unit <= largest))
      throw ParameterError("The parameter '" + std::string(name) +
                           "' is out of its range: it must be from a thousandth of "
                           "the average edge length to a million of them, or 0 for automatic.");
  if (p.smoothing_passes > limits::max_smoothing_passes)
    throw ParameterError("The parameter 'smoothing_passes' must be at most " +
                         std::to_string(limits::max_smoothing_passes) + ".");
}

/// Lines may lie half a spacing apart, with a sample each quarter of it.
void require_memory_for_lines(const Surface& surface, double spacing, std::size_t limit_mb, Execution& execution)
{
  const std::vector<double> areas = vertex_areas(surface, execution);
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  const double samples = 8 * area / (spacing * spacing);
  require_memory(samples * sizeof(LineSample), limit_mb, "Lines of curvature this close", "Raise spacing");
}

std::vector<double> anisotropies(const CurvatureField& field, Execution& execution)
{
  const double typical = typical_curvature(field);
  execution.check();
  std::vector<double> values(field.size());
  for_each_index(values.size(), execution,
                 [&](std::size_t v) { values[v] = anisotropy(field.kappa_max[v], field.kappa_min[v], typical); });
  return values;
}

/// Triangles by falling anisotropy of their centre.
std::vector<std::uint32_t> clearest_first(const std::vector<Triangle>& triangles, const std::vector<double>& clarity,
                                          Execution& execution)
{
  std::vector<double> sum;
  resize_in_steps(sum, triangles.size(), execution);
  double largest = 0;
  for_each_in_order(triangles.size(), execution, [&](std::size_t t) {
    sum[t] = clarity[triangles[t][0]] + clarity[triangles[t][1]] + clarity[triangles[t][2]];
    largest = std::max(largest, sum[t]);
  });
  // Coarsely first, so that workers can sort, and none for long.
  constexpr std::size_t ranks = 4096;
  const double ranks_per_unit = largest > 0 ? double(ranks - 1) / largest : 0;
  Buckets<std::uint32_t> order =
      in_buckets<std::uint32_t>(triangles.size(), ranks, execution, [&](std::size_t t, const auto& put) {
        put(std::size_t((largest - std::max(sum[t], 0.0)) * ranks_per_unit), std::uint32_t(t));
      });
  parallel_step(ranks, 16, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t rank = begin; rank < end; ++rank)
      std::stable_sort(order.begin(rank), order.end(rank),
                       [&](std::uint32_t a, std::uint32_t b) { return sum[a] > sum[b]; });
  });
  return std::move(order.items);
}

void trace_family(LineTracer& tracer, const std::vector<std::uint32_t>& order, Execution& execution, double from,
                  double share, std::vector<CurvatureLine>& lines)
{
  std::deque<WalkState> beside;
  const auto try_seed = [&](const WalkState& seed) {
    if (!seed.is_on_surface() || !tracer.has_room(seed, seed_tolerance)) return;
    CurvatureLine line;
    if (!tracer.trace(seed, line)) return;
    for (const WalkState& next : tracer.seeds_beside()) beside.push_back(next);
    lines.push_back(std::move(line));
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (; !beside.empty(); beside.pop_front()) {
      execution.report(from + share * double(i) / double(order.size()));
      try_seed(beside.front());
    }
    if (i % 256 == 0) execution.report(from + share * double(i) / double(order.size()));
    try_seed({std::int32_t(order[i]), {1.0 / 3, 1.0 / 3, 1.0 / 3}, {}});
  }
}

}  // namespace

double anisotropy(double kappa_max, double kappa_min, double typical)
{
  const double size = std::hypot(std::max(std::abs(kappa_max), std::abs(kappa_min)), typical);
  return size > 0 ? (kappa_max - kappa_min) / size : 0;
}

double typical_curvature(const CurvatureField& field)
{
  if (field.size() == 0) return 0;
  std::vector<double> largest(field.size());
  for (std::size_t v = 0; v < largest.size(); ++v)
    largest[v] = std::max(std::abs(field.kappa_max[v]), std::abs(field.kappa_min[v]));
  const auto middle = largest.begin() + std::ptrdiff_t(largest.size() / 2);
  std::nth_element(largest.begin(), middle, largest.end());
  return *middle;
}

std::vector<DirectionSegment> direction_segments(const Surface& surface, const CurvatureField& field,
                                                 const DirectionParameters& p, Execution& execution)
{
  require_lengths(p, surface.unit());
  const double spacing = spacing_of(p, surface.unit());
  const double length = p.segment_length > 0 ? p.segment_length : automatic_segment * spacing * surface.unit();
  const std::vector<double> clarity = anisotropies(field, execution);
  PointGrid taken(spacing);
  std::vector<DirectionSegment> segments;
  for_each_in_order(surface.vertex_count(), execution, [&](std::size_t v) {
    if (!surface.is_referenced(v) || clarity[v] < p.umbilic) return;
    const Vec3 &place = surface.positions()[v], &normal = field.normal[v];
    if (taken.any_near(place, normal, spacing, [](const LineSample&) { return true; })) return;
    taken.add({place, normal, 0, 0});
    if (p.maximal) segments.push_back({DirectionFamily::maximal, std::int32_t(v), field.dir_max[v] * (length / 2)});
    if (p.minimal) segments.push_back({DirectionFamily::minimal, std::int32_t(v), field.dir_min[v] * (length / 2)});
  });
  return segments;
}

std::vector<CurvatureLine> trace_curvature_lines(const Surface& surface, const CurvatureField& field,
                                                 const DirectionParameters& p, Execution& execution)
{
  require_lengths(p, surface.unit());
  require_memory_for_lines(surface, spacing_of(p, surface.unit()), p.memory_limit_mb, execution);
  constexpr double smoothed_by = 0.2, traced_from = 0.4;  // fractions of the stage
  const CurvatureField smooth = smoothed(surface, field, p.smoothing_passes, execution, smoothed_by);
  const Topology topology(surface, execution);
  execution.report(traced_from);
  const std::vector<double> clarity = anisotropies(smooth, execution);
  const std::vector<std::uint32_t> order = clearest_first(surface.triangles(), clarity, execution);
  const double spacing = spacing_of(p, surface.unit());
  const double minimum = p.minimum_length > 0 ? p.minimum_length / surface.unit() : automatic_minimum * spacing;
  std::vector<CurvatureLine> lines;
  for (const DirectionFamily family : {DirectionFamily::maximal, DirectionFamily::minimal}) {
    const bool maximal = family == DirectionFamily::maximal;
    if (!(maximal ? p.maximal : p.minimal)) continue;
    LineTracer tracer(surface, topology, maximal ? smooth.dir_max : smooth.dir_min, clarity,
                      {family, spacing, minimum, p.umbilic});
    trace_family(tracer, order, execution, maximal ? traced_from : (1 + traced_from) / 2, (1 - traced_from) / 2, lines);
  }
  return lines;
}

}  // namespace integral_invariant
