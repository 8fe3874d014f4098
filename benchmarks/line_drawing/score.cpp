// SPDX-License-Identifier: GPL-3.0-or-later
#include "score.h"

#include <array>
#include <cmath>
#include <unordered_map>

namespace line_benchmark {

using integral_invariant::norm;
using integral_invariant::squared_norm;

namespace {

constexpr double sample = 0.1;  // in units of the tolerance

/// Points along the segments, and how long a piece each stands for.
struct Samples {
  std::vector<Vec3> points;
  std::vector<double> lengths;
  double total = 0;
};

Samples sampled(const std::vector<ExactSegment>& segments, double step)
{
  Samples s;
  for (const ExactSegment& segment : segments) {
    const double length = norm(segment.b - segment.a);
    const int pieces = std::max(1, int(std::ceil(length / step)));
    for (int i = 0; i < pieces; ++i) {
      s.points.push_back(segment.a + (segment.b - segment.a) * ((i + 0.5) / pieces));
      s.lengths.push_back(length / pieces);
    }
    s.total += length;
  }
  return s;
}

class Near {
 public:
  Near(const std::vector<Vec3>& points, double distance) : points_(points), distance_(distance)
  {
    for (std::size_t i = 0; i < points.size(); ++i) cells_[key(points[i], 0)].push_back(i);
  }

  bool is_near(const Vec3& p) const
  {
    for (int i = 0; i < 27; ++i) {
      const auto cell = cells_.find(key(p, i));
      if (cell == cells_.end()) continue;
      for (const std::size_t q : cell->second)
        if (squared_norm(points_[q] - p) <= distance_ * distance_) return true;
    }
    return false;
  }

 private:
  /// Of the cell around `p` (0), or beside it.
  std::uint64_t key(const Vec3& p, int beside) const
  {
    constexpr std::array<int, 3> shift{0, 1, -1};
    const auto part = [&](double x, int i) {
      return std::uint64_t(std::int64_t(std::floor(x / distance_)) + shift[std::size_t(i)]) & 0x1fffff;
    };
    return part(p.x, beside % 3) << 42 | part(p.y, beside / 3 % 3) << 21 | part(p.z, beside / 9);
  }

  const std::vector<Vec3>& points_;
  double distance_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

double share_near(const Samples& of, const Samples& to, double tolerance)
{
  if (!(of.total > 0)) return 1;
  const Near near(to.points, tolerance);
  double sum = 0;
  for (std::size_t i = 0; i < of.points.size(); ++i)
    if (near.is_near(of.points[i])) sum += of.lengths[i];
  return sum / of.total;
}

}  // namespace

Score score(const std::vector<ExactSegment>& exact, const std::vector<ExactSegment>& drawn, double tolerance)
{
  const Samples e = sampled(exact, sample * tolerance), d = sampled(drawn, sample * tolerance);
  Score s;
  s.drawn = d.total;
  s.exact = e.total;
  s.precision = share_near(d, e, tolerance);
  s.recall = share_near(e, d, tolerance);
  s.length_ratio = e.total > 0 ? d.total / e.total : d.total > 0 ? HUGE_VAL : 1;  // none where none is to be
  return s;
}

}  // namespace line_benchmark
