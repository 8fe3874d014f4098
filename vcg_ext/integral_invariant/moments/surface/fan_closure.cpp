// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: closing the surface around a vertex where it ends, by continuing the tangent plane.
#include "integral_invariant/moments/surface/fan_closure.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

namespace {

constexpr double turn = 6.28318530717958647692;
/// Rays that nearly coincide are the two sides of one cut (a vertex on another triangle's edge), not a gap of a full
/// turn.
constexpr double same_ray = 0.05;
constexpr double longest_step = 1.5;  // of the way through a gap: well under half a turn

using Arcs = std::vector<std::pair<Vec3, Vec3>>;

/// Tangent directions u cos + v sin.
struct TangentFrame {
  Vec3 u, v;
  Vec3 at(double angle) const { return u * std::cos(angle) + v * std::sin(angle); }
};

void add_gap(const FanRay& from, const FanRay& to, double width, const TangentFrame& frame, Arcs& arcs)
{
  const int steps = std::max(1, int(std::ceil(width / longest_step)));
  Vec3 start = from.direction;
  for (int i = 1; i <= steps; ++i) {
    const Vec3 end = i == steps ? to.direction : frame.at(from.angle + width * i / steps);
    arcs.emplace_back(start, end);
    start = end;
  }
}

/// Joins neighbours in angle that nearly coincide, one arriving and one leaving; the others stay.
std::vector<FanRay> join_coinciding(const std::vector<FanRay>& rays, Arcs& arcs)
{
  std::vector<FanRay> left;
  for (const FanRay& ray : rays) {
    if (!left.empty() && left.back().arriving != ray.arriving && ray.angle - left.back().angle < same_ray) {
      const FanRay& other = left.back();
      arcs.emplace_back(ray.arriving ? ray.direction : other.direction, ray.arriving ? other.direction : ray.direction);
      left.pop_back();
    } else {
      left.push_back(ray);
    }
  }
  return left;
}

}  // namespace

Arcs close_fans(std::vector<FanRay> rays, const Vec3& normal, double& gap)
{
  TangentFrame frame;
  frame.u = any_orthogonal(normal);
  frame.v = cross(normal, frame.u);
  // Angles start a little before 0 so that a pair that coincides there is not torn apart by the cut at a full turn.
  for (FanRay& ray : rays) {
    ray.angle = std::atan2(dot(ray.direction, frame.v), dot(ray.direction, frame.u));
    if (ray.angle < -turn / 2 + 2 * same_ray) ray.angle += turn;
  }
  std::stable_sort(rays.begin(), rays.end(), [](const FanRay& a, const FanRay& b) { return a.angle < b.angle; });

  Arcs arcs;
  rays = join_coinciding(rays, arcs);
  // Twice around: each leaving ray takes the nearest arriving one before it that is still open.
  std::vector<FanRay> open;
  std::vector<char> is_closed(rays.size(), 0);
  for (int round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (rays[i].arriving) {
        if (round == 0) open.push_back(rays[i]);
      } else if (!is_closed[i] && !open.empty()) {
        const double width = rays[i].angle + turn * round - open.back().angle;
        add_gap(open.back(), rays[i], width, frame, arcs);
        gap += width;
        open.pop_back();
        is_closed[i] = 1;
      }
    }
  return arcs;
}

}  // namespace integral_invariant
