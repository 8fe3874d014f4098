// SPDX-License-Identifier: GPL-3.0-or-later
// Ridge and valley regions: threshold, flood, sieve. In: curvatures. Out: kind and region of every vertex.
#include "integral_invariant/features/ridges_valleys.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "integral_invariant/error.h"
#include "integral_invariant/features/topology.h"

namespace integral_invariant {

namespace {

/// What a vertex would be if it passed, and how strongly.
struct Candidate {
  FeatureKind kind = FeatureKind::none;
  double strength = 0;  ///< |κ|, 1/L
};

Candidate candidate(double kappa_max, double kappa_min, const RidgeValleyParameters& p)
{
  const double ridge = p.ridges ? kappa_max : -1, valley = p.valleys ? -kappa_min : -1;
  if (std::max(ridge, valley) <= 0) return {};
  return ridge >= valley ? Candidate{FeatureKind::ridge, ridge} : Candidate{FeatureKind::valley, valley};
}

struct Thresholds {
  double high, low;
};

void require(bool holds, const char* sentence)
{
  if (!holds) throw ParameterError(sentence);
}

/// The value that `percent` of them do not exceed; puts them in another order.
double at_percent(std::vector<double>& values, double percent)
{
  const double position = percent / 100 * double(values.size() - 1);
  const auto there = values.begin() + std::ptrdiff_t(std::min(std::size_t(std::ceil(position)), values.size() - 1));
  std::nth_element(values.begin(), there, values.end());
  return *there;
}

Thresholds thresholds(const Surface& surface, const Result& result, const RidgeValleyParameters& p,
                      Execution& execution)
{
  if (p.threshold == FeatureThreshold::curvature) {
    require(p.high_curvature > 0,
            "The high threshold must be a curvature above 0 (1/length): set high_curvature, or use percentiles.");
    require(p.low_curvature >= 0 && p.low_curvature <= p.high_curvature,
            "The low threshold must not exceed the high one: lower low_curvature, or set it to 0 for half of "
            "high_curvature.");
    return {p.high_curvature, p.low_curvature > 0 ? p.low_curvature : p.high_curvature / 2};
  }
  require(p.high_percentile >= 0 && p.high_percentile <= 100 && p.low_percentile >= 0,
          "The percentiles of the thresholds must lie from 0 to 100: change high_percentile or low_percentile.");
  require(p.low_percentile <= p.high_percentile,
          "The low threshold must not exceed the high one: lower low_percentile or raise high_percentile.");
  std::vector<double> largest;
  for_each_in_order(result.kappa_max.size(), execution, [&](std::size_t v) {
    if (surface.is_referenced(v))
      largest.push_back(std::max(std::abs(result.kappa_max[v]), std::abs(result.kappa_min[v])));
  });
  return {at_percent(largest, p.high_percentile), at_percent(largest, p.low_percentile)};
}

/// Collects the region around one strong vertex; `region` marks whom it took.
std::vector<std::uint32_t> flood(const Surface& surface, const std::vector<Candidate>& candidates, double low,
                                 std::uint32_t seed, std::int32_t index, std::vector<std::int32_t>& region)
{
  std::vector<std::uint32_t> members{seed};
  region[seed] = index;
  for (std::size_t next = 0; next < members.size(); ++next) {
    const std::uint32_t v = members[next];
    for (std::uint32_t e = surface.neighbour_start()[v]; e < surface.neighbour_start()[v + 1]; ++e) {
      const std::uint32_t u = surface.neighbours()[e];
      const Candidate& c = candidates[u];
      if (region[u] != -1 || c.kind != candidates[seed].kind || c.strength < low) continue;
      region[u] = index;
      members.push_back(u);
    }
  }
  return members;
}

}  // namespace

RidgeValleyRegions find_ridges_and_valleys(const Surface& surface, const Result& result, const RidgeValleyParameters& p,
                                           Execution& execution)
{
  const std::size_t n = surface.vertex_count();
  const Thresholds threshold = thresholds(surface, result, p, execution);
  const std::vector<double> areas = vertex_areas(surface, execution);
  const double unit_area = surface.unit() * surface.unit();
  std::vector<Candidate> candidates(n);
  for_each_index(n, execution, [&](std::size_t v) {
    if (surface.is_referenced(v)) candidates[v] = candidate(result.kappa_max[v], result.kappa_min[v], p);
  });

  RidgeValleyRegions found;
  found.kind.assign(n, FeatureKind::none);
  found.region.assign(n, -1);
  found.high = threshold.high;
  found.low = threshold.low;
  constexpr std::int32_t dropped = -2;
  for_each_in_order(n, execution, [&](std::size_t seed) {
    if (found.region[seed] != -1 || candidates[seed].kind == FeatureKind::none ||
        candidates[seed].strength < threshold.high)
      return;
    const auto members = flood(surface, candidates, threshold.low, std::uint32_t(seed),
                               std::int32_t(found.regions.size()), found.region);
    FeatureRegion region{candidates[seed].kind, members.size()};
    for (const std::uint32_t v : members) {
      region.area += areas[v] * unit_area;
      region.peak = std::max(region.peak, candidates[v].strength);
    }
    const bool keep = members.size() >= std::size_t(std::max(p.minimum_vertices, 0)) && region.area >= p.minimum_area;
    for (const std::uint32_t v : members) {
      if (keep)
        found.kind[v] = region.kind;
      else
        found.region[v] = dropped;
    }
    if (keep) found.regions.push_back(region);
  });
  std::replace(found.region.begin(), found.region.end(), dropped, -1);
  return found;
}

}  // namespace integral_invariant
