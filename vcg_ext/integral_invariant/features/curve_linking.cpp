// SPDX-License-Identifier: GPL-3.0-or-later
// Joining of the segments of curves, and their cutting. In: a segment or none a triangle. Out: chains of triangles.
// Cost: O(m).
#include "integral_invariant/features/curve_linking.h"

#include <algorithm>

namespace integral_invariant {

namespace {

constexpr std::size_t longest_gap = 3;

class Linker {
 public:
  Linker(const Topology& topology, const std::vector<CurveSegment>& segments)
      : topology_(topology), segments_(segments), used_(segments.size(), 0)
  {
  }

  bool is_used(std::size_t triangle) const { return used_[triangle]; }

  /// The whole curve through `triangle`.
  Curve through(std::int32_t triangle)
  {
    Curve curve;
    const CurveSegment& segment = segments_[triangle];
    curve.steps = follow({triangle, segment.side[0], segment.side[1]});
    const CurveStep& last = curve.steps.back();
    curve.closed = curve.steps.size() > 2 && topology_.across[last.triangle][last.leave] == triangle &&
                   topology_.edge[last.triangle][last.leave] == topology_.edge[triangle][segment.side[0]];
    if (curve.closed) return curve;
    used_[triangle] = 0;
    std::vector<CurveStep> back = follow({triangle, segment.side[1], segment.side[0]});
    std::reverse(back.begin(), back.end());
    for (CurveStep& step : back) std::swap(step.enter, step.leave);
    curve.steps.insert(curve.steps.begin(), back.begin(), back.end() - 1);
    return curve;
  }

 private:
  std::vector<CurveStep> follow(CurveStep step)
  {
    std::vector<CurveStep> steps;
    while (true) {
      used_[step.triangle] = 1;
      steps.push_back(step);
      const std::int32_t next = topology_.across[step.triangle][step.leave];
      if (next < 0 || used_[next] || !segments_[next].exists) return steps;
      const std::int32_t edge = topology_.edge[step.triangle][step.leave];
      const auto& side = segments_[next].side;
      if (topology_.edge[next][side[0]] == edge)
        step = {next, side[0], side[1]};
      else if (topology_.edge[next][side[1]] == edge)
        step = {next, side[1], side[0]};
      else
        return steps;
    }
  }

  const Topology& topology_;
  const std::vector<CurveSegment>& segments_;
  std::vector<char> used_;
};

void close_gaps(std::vector<char>& keep, bool closed)
{
  const std::vector<char> before = keep;
  const std::size_t n = keep.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!before[i]) continue;
    for (std::size_t gap = 1; gap <= longest_gap; ++gap) {
      const std::size_t end = i + gap + 1;
      if ((end >= n && !closed) || before[(i + gap) % n]) break;
      if (!before[end % n]) continue;
      for (std::size_t k = i + 1; k < end; ++k) keep[k % n] = 1;
      break;
    }
  }
}

}  // namespace

std::vector<Curve> link_curves(const Topology& topology, const std::vector<CurveSegment>& segments,
                               Execution& execution)
{
  Linker linker(topology, segments);
  std::vector<Curve> curves;
  for_each_in_order(segments.size(), execution, [&](std::size_t t) {
    if (segments[t].exists && !linker.is_used(t)) curves.push_back(linker.through(std::int32_t(t)));
  });
  return curves;
}

std::vector<Stretch> kept_stretches(std::vector<char> keep, bool closed)
{
  close_gaps(keep, closed);
  const std::size_t n = keep.size();
  const auto gap = std::find(keep.begin(), keep.end(), 0);
  const std::size_t start = closed && gap != keep.end() ? std::size_t(gap - keep.begin()) : 0;
  std::vector<Stretch> stretches;
  for (std::size_t begin = 0; begin < n;) {
    std::size_t end = begin;
    while (end < n && keep[(start + end) % n] == keep[(start + begin) % n]) ++end;
    if (keep[(start + begin) % n]) stretches.push_back({(start + begin) % n, end - begin});
    begin = end;
  }
  return stretches;
}

}  // namespace integral_invariant
