// SPDX-License-Identifier: GPL-3.0-or-later
// Joining of crest segments. In: a segment or none a triangle. Out: chains of triangles. Cost: O(m).
#include "integral_invariant/features/crest_linking.h"

namespace integral_invariant {

namespace {

void cut(const Curve& curve, const std::vector<CrestSegment>& segments, std::vector<Curve>& chains)
{
  const std::size_t n = curve.steps.size();
  std::vector<char> extremum(n);
  for (std::size_t i = 0; i < n; ++i) extremum[i] = segments[curve.steps[i].triangle].extremum;
  for (const Stretch& stretch : kept_stretches(std::move(extremum), curve.closed)) {
    Curve chain;
    for (std::size_t i = 0; i < stretch.count; ++i) chain.steps.push_back(curve.steps[(stretch.first + i) % n]);
    chain.closed = curve.closed && stretch.count == n;
    chains.push_back(std::move(chain));
  }
}

}  // namespace

std::vector<Curve> link_segments(const Topology& topology, const std::vector<CrestSegment>& segments,
                                 Execution& execution)
{
  std::vector<CurveSegment> pieces;
  resize_in_steps(pieces, segments.size(), execution);
  for_each_index(segments.size(), execution, [&](std::size_t t) { pieces[t] = segments[t].piece; });
  std::vector<Curve> chains;
  for (const Curve& curve : link_curves(topology, pieces, execution)) cut(curve, segments, chains);
  return chains;
}

}  // namespace integral_invariant
