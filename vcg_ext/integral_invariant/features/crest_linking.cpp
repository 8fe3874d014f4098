// SPDX-License-Identifier: GPL-3.0-or-later
// Joining of crest segments. In: a segment or none a triangle. Out: chains of triangles. Cost: O(m).
#include "integral_invariant/features/crest_linking.h"

#include <algorithm>

namespace integral_invariant {

namespace {

constexpr std::size_t longest_gap = 3;

class Linker {
 public:
  Linker(const Topology& topology, const std::vector<CrestSegment>& segments)
      : topology_(topology), segments_(segments), used_(segments.size(), 0)
  {
  }

  /// The whole curve through `triangle`, extrema or not.
  CrestChain curve_through(std::int32_t triangle)
  {
    CrestChain chain;
    const CrestSegment& segment = segments_[triangle];
    chain.steps = follow({triangle, segment.side[0], segment.side[1]});
    const CrestStep& last = chain.steps.back();
    chain.closed = chain.steps.size() > 2 && topology_.across[last.triangle][last.leave] == triangle &&
                   topology_.edge[last.triangle][last.leave] == topology_.edge[triangle][segment.side[0]];
    if (chain.closed) return chain;
    used_[triangle] = 0;
    std::vector<CrestStep> back = follow({triangle, segment.side[1], segment.side[0]});
    std::reverse(back.begin(), back.end());
    for (CrestStep& step : back) std::swap(step.enter, step.leave);
    chain.steps.insert(chain.steps.begin(), back.begin(), back.end() - 1);
    return chain;
  }

  bool is_used(std::size_t triangle) const { return used_[triangle]; }

 private:
  std::vector<CrestStep> follow(CrestStep step)
  {
    std::vector<CrestStep> steps;
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
  const std::vector<CrestSegment>& segments_;
  std::vector<char> used_;
};

/// Which steps to keep: extrema, and short gaps between them.
std::vector<char> kept_steps(const CrestChain& chain, const std::vector<CrestSegment>& segments)
{
  const std::size_t n = chain.steps.size();
  std::vector<char> keep(n);
  for (std::size_t i = 0; i < n; ++i) keep[i] = segments[chain.steps[i].triangle].extremum;
  const std::vector<char> extremum = keep;
  for (std::size_t i = 0; i < n; ++i) {
    if (!extremum[i]) continue;
    for (std::size_t gap = 1; gap <= longest_gap; ++gap) {
      const std::size_t j = i + gap + 1;
      if (j >= n && !chain.closed) break;
      if (extremum[(i + gap) % n]) break;
      if (!extremum[j % n]) continue;
      for (std::size_t k = i + 1; k < j; ++k) keep[k % n] = 1;
      break;
    }
  }
  return keep;
}

void cut(CrestChain curve, const std::vector<CrestSegment>& segments, std::vector<CrestChain>& chains)
{
  std::vector<char> keep = kept_steps(curve, segments);
  const auto first_gap = std::find(keep.begin(), keep.end(), 0);
  if (first_gap == keep.end()) {
    chains.push_back(std::move(curve));
    return;
  }
  if (curve.closed) {  // a loop starts at a gap, so that no line is cut at the start
    const auto shift = first_gap - keep.begin();
    std::rotate(keep.begin(), first_gap, keep.end());
    std::rotate(curve.steps.begin(), curve.steps.begin() + shift, curve.steps.end());
  }
  for (std::size_t begin = 0; begin < keep.size();) {
    std::size_t end = begin;
    while (end < keep.size() && keep[end] == keep[begin]) ++end;
    if (keep[begin]) chains.push_back({{curve.steps.begin() + begin, curve.steps.begin() + end}, false});
    begin = end;
  }
}

}  // namespace

std::vector<CrestChain> link_segments(const Topology& topology, const std::vector<CrestSegment>& segments,
                                      Execution& execution)
{
  Linker linker(topology, segments);
  std::vector<CrestChain> chains;
  for_each_in_order(segments.size(), execution, [&](std::size_t t) {
    if (segments[t].exists && !linker.is_used(t)) cut(linker.curve_through(std::int32_t(t)), segments, chains);
  });
  return chains;
}

}  // namespace integral_invariant
