// SPDX-License-Identifier: GPL-3.0-or-later
// Low pass along lines. In: polyline with points at every crossing of an edge. Out: evenly spaced points.
#include "integral_invariant/drawing/line_smoothing.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

namespace {

LinePoint mixed(const LinePoint& a, const LinePoint& b, double t)
{
  return {a.position * (1 - t) + b.position * t, normalized(a.normal * (1 - t) + b.normal * t),
          a.significance * (1 - t) + b.significance * t, a.strength * (1 - t) + b.strength * t};
}

/// Points at even distances along the line; a closed one's last point is a spacing away from its first.
std::vector<LinePoint> resampled(const SurfaceLine& line, double spacing)
{
  const double length = line.length();
  const std::size_t steps = std::max<std::size_t>(line.closed ? 3 : 1, std::size_t(std::llround(length / spacing)));
  std::vector<LinePoint> points;
  points.reserve(steps + 1);
  double before = 0;
  std::size_t segment = 0;
  for (std::size_t i = 0; i < steps + (line.closed ? 0 : 1); ++i) {
    const double arc = length * double(i) / double(steps);
    while (segment + 1 < line.segment_count() && before + line.length_of(segment) < arc)
      before += line.length_of(segment++);
    const double ds = line.length_of(segment);
    points.push_back(
        mixed(line.points[segment], line.end_of(segment), ds > 0 ? std::min(1.0, (arc - before) / ds) : 0));
  }
  return points;
}

/// Weighted sums for a quadratic fit in the distance along the line.
struct QuadraticFit {
  double s[5]{};  // of w tᵏ
  Vec3 p[3];      // of w tᵏ position

  void add(double t, double w, const Vec3& position)
  {
    double power = w;
    for (int k = 0; k < 5; ++k, power *= t) {
      s[k] += power;
      if (k < 3) p[k] += position * power;
    }
  }

  /// At t = 0, by Cramer's rule.
  Vec3 value() const
  {
    const double c0 = s[2] * s[4] - s[3] * s[3], c1 = s[2] * s[3] - s[1] * s[4], c2 = s[1] * s[3] - s[2] * s[2];
    const double determinant = s[0] * c0 + s[1] * c1 + s[2] * c2;
    return (p[0] * c0 + p[1] * c1 + p[2] * c2) * (1 / determinant);
  }
};

}  // namespace

SurfaceLine smoothed_line(const SurfaceLine& line, double width, double spacing)
{
  SurfaceLine result{line.kind, resampled(line, spacing), line.closed};
  const std::vector<LinePoint> even = result.points;
  const long n = long(even.size()), reach = std::lround(std::ceil(2.5 * width / spacing));
  constexpr long fewest = 3;  // points of a quadratic
  if (n <= fewest) return result;
  const double step = line.length() / double(line.closed ? n : n - 1);
  for (long i = 0; i < n; ++i) {
    QuadraticFit fit;
    Vec3 normal;
    double weights = 0, significance = 0, strength = 0;
    const long span = line.closed ? std::min(reach, (n - 1) / 2) : reach;
    for (long k = -span; k <= span; ++k) {
      if (!line.closed && (i + k < 0 || i + k >= n)) continue;
      const LinePoint& p = even[std::size_t((i + k + n) % n)];
      const double t = double(k) * step / width, w = std::exp(-t * t / 2);
      fit.add(t, w, p.position);
      normal += p.normal * w;
      weights += w;
      significance += w * p.significance;
      strength += w * p.strength;
    }
    result.points[std::size_t(i)] = {fit.value(), normalized(normal), significance / weights, strength / weights};
  }
  return result;
}

}  // namespace integral_invariant
