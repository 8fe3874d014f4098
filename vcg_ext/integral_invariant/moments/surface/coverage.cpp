// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: how much of a flat disc is missing where boundary edges pass within a ball.
#include "integral_invariant/moments/surface/coverage.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/support/pi.h"

namespace integral_invariant {

namespace {

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

}  // namespace

void MissingArea::add(const Vec3& start, const Vec3& end, double sign)
{
  const double seen = sign * angle_between(start, end);
  angle += seen;
  moment += seen * 0.25 * squared_norm(start + end);
}

double confidence(const MissingArea& missing, double squared_radius)
{
  return std::clamp(1 - (squared_radius * missing.angle - missing.moment) / (2 * pi * squared_radius), 0.0, 1.0);
}

double boundary_side(std::int32_t surplus, const Vec3& a, const Vec3& b, const Vec3& opposite)
{
  if (surplus > 1) return 1;
  const Vec3 e = b - a, inward = (opposite - a) - e * (dot(opposite - a, e) / std::max(squared_norm(e), 1e-300));
  return dot(inward, a) <= 0 ? 1 : -1;
}

bool passes_origin(const Vec3& a, const Vec3& b)
{
  const Vec3 e = b - a;
  const double along = -dot(a, e), length2 = squared_norm(e);
  if (!(along > 0 && along < length2)) return false;
  return squared_norm(cross(a, e)) < touching * touching * length2 * length2;
}

}  // namespace integral_invariant
