// SPDX-License-Identifier: GPL-3.0-or-later
// Visibility by the depth of the triangles over a point. Cost: about a microsecond a point.
#include "integral_invariant/drawing/visibility.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

namespace {

constexpr double cell = 2;         // ē
constexpr double height = 1;       // ē: over the surface, at which a point is tried
constexpr double clearance = 1.5;  // ē: of what covers it
constexpr std::size_t most_cells = std::size_t(1) << 24;

/// Runs shorter than `shortest` take the value around them; those at the ends of an open line stay.
void drop_short_runs(std::vector<char>& values, bool closed, std::size_t shortest)
{
  const std::size_t n = values.size();
  std::size_t start = 0;
  if (closed) {
    while (start < n && values[start] == values[(start + n - 1) % n]) ++start;
    if (start == n) return;
  }
  for (std::size_t i = 0; i < n;) {
    std::size_t end = i;
    while (end < n && values[(start + end) % n] == values[(start + i) % n]) ++end;
    const bool inner = closed ? i > 0 : i > 0 && end < n;
    if (inner && end - i < shortest)
      for (std::size_t k = i; k < end; ++k) values[(start + k) % n] = values[(start + i - 1) % n];
    i = end;
  }
}

}  // namespace

DepthGrid::DepthGrid(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles, const View& view,
                     Execution& execution)
    : triangles_(triangles)
{
  resize_in_steps(projected_, positions.size(), execution);
  for_each_index(positions.size(), execution, [&](std::size_t v) { projected_[v] = view.project(positions[v]); });
  Box box;
  for (const Triangle& t : triangles)
    for (const std::int32_t v : t) box.add(projected_[v]);
  left_ = box.low.x;
  bottom_ = box.low.y;
  columns_ = std::size_t(std::clamp((box.high.x - box.low.x) / cell + 1, 1.0, 1e6));
  rows_ = std::clamp<std::size_t>(std::size_t((box.high.y - box.low.y) / cell + 1), 1, most_cells / columns_ + 1);
  const auto for_cells_of = [&](const Triangle& t, const auto& visit) {
    Box b;
    for (const std::int32_t v : t) b.add(projected_[v]);
    const std::size_t first = cell_of(b.low.x, b.low.y), last = cell_of(b.high.x, b.high.y);
    for (std::size_t row = first / columns_; row <= last / columns_; ++row)
      for (std::size_t column = first % columns_; column <= last % columns_; ++column) visit(row * columns_ + column);
  };
  resize_in_steps(start_, columns_ * rows_ + 1, execution);
  for_each_in_order(triangles.size(), execution,
                    [&](std::size_t t) { for_cells_of(triangles[t], [&](std::size_t c) { ++start_[c + 1]; }); });
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  resize_in_steps(members_, start_.back(), execution);
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for_each_in_order(triangles.size(), execution, [&](std::size_t t) {
    for_cells_of(triangles[t], [&](std::size_t c) { members_[next[c]++] = std::uint32_t(t); });
  });
}

std::size_t DepthGrid::cell_of(double x, double y) const
{
  const double column = std::clamp((x - left_) / cell, 0.0, double(columns_ - 1));
  const double row = std::clamp((y - bottom_) / cell, 0.0, double(rows_ - 1));
  return std::size_t(row) * columns_ + std::size_t(column);
}

bool DepthGrid::is_covered(const Vec3& point, double least_clearance) const
{
  const std::size_t c = cell_of(point.x, point.y);
  for (std::uint32_t i = start_[c]; i < start_[c + 1]; ++i) {
    const Triangle& t = triangles_[members_[i]];
    const Vec3 a = projected_[t[0]] - point, b = projected_[t[1]] - point, d = projected_[t[2]] - point;
    if (std::max({a.z, b.z, d.z}) <= least_clearance) continue;
    const double wa = b.x * d.y - b.y * d.x, wb = d.x * a.y - d.y * a.x, wd = a.x * b.y - a.y * b.x;
    const double sum = wa + wb + wd;
    if (sum == 0 || wa * sum < 0 || wb * sum < 0 || wd * sum < 0) continue;
    if ((wa * a.z + wb * b.z + wd * d.z) / sum > least_clearance) return true;
  }
  return false;
}

std::vector<char> visible_points(const SurfaceLine& line, const DepthGrid& grid, const View& view,
                                 double shortest_change)
{
  const std::size_t n = line.points.size();
  std::vector<char> visible(n);
  for (std::size_t i = 0; i < n; ++i) {
    const LinePoint& p = line.points[i];
    // A boundary is seen from behind as well.
    const bool from_behind = line.kind == LineKind::boundary && dot(p.normal, view.toward) < 0;
    const Vec3 above = p.position + p.normal * (from_behind ? -height : height);
    const bool hides_itself = line.kind == LineKind::contour && p.strength < 0;
    visible[i] = !hides_itself && !grid.is_covered(view.project(above), clearance);
  }
  const double step = line.length() / double(std::max<std::size_t>(1, line.segment_count()));
  drop_short_runs(visible, line.closed, std::size_t(std::ceil(shortest_change / step)));
  return visible;
}

}  // namespace integral_invariant
