// SPDX-License-Identifier: GPL-3.0-or-later
// Simplification of polylines, without recursion: lines may have a million points.
#include "integral_invariant/drawing/simplification.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace integral_invariant {

namespace {

double distance_to_segment(const PaperPoint& p, const PaperPoint& a, const PaperPoint& b)
{
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

}  // namespace

PaperLine simplified(const PaperLine& line, double tolerance)
{
  std::vector<PaperPoint> points = line.points;
  if (points.size() < 3) return line;
  if (line.closed) points.push_back(points.front());
  std::vector<char> keep(points.size());
  keep.front() = keep.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double most = tolerance;
    std::size_t farthest = first;
    for (std::size_t i = first + 1; i < last; ++i)
      if (const double d = distance_to_segment(points[i], points[first], points[last]); d > most) {
        most = d;
        farthest = i;
      }
    if (farthest == first) continue;
    keep[farthest] = 1;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  PaperLine result{{}, line.closed, line.width};
  for (std::size_t i = 0; i < points.size() - (line.closed ? 1 : 0); ++i)
    if (keep[i]) result.points.push_back(points[i]);
  return result;
}

}  // namespace integral_invariant
