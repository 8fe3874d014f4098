// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: a hierarchy of bounding spheres over items that are already sorted in space.
#include "integral_invariant/moments/surface/bounding_tree.h"

#include <limits>

namespace integral_invariant {

Sphere bounding_sphere(const Sphere* spheres, std::size_t count)
{
  constexpr double huge = std::numeric_limits<double>::max();
  Vec3 low{huge, huge, huge}, high{-huge, -huge, -huge};
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& c = spheres[i].centre;
    const double r = spheres[i].radius;
    low = {std::min(low.x, c.x - r), std::min(low.y, c.y - r), std::min(low.z, c.z - r)};
    high = {std::max(high.x, c.x + r), std::max(high.y, c.y + r), std::max(high.z, c.z + r)};
  }
  Sphere bound{(low + high) * 0.5, 0};
  for (std::size_t i = 0; i < count; ++i)
    bound.radius = std::max(bound.radius, norm(spheres[i].centre - bound.centre) + spheres[i].radius);
  return bound;
}

void BoundingTree::add_level()
{
  const std::vector<Sphere>& below = levels_.back();
  std::vector<Sphere> level;
  for (std::size_t begin = 0; begin < below.size(); begin += fan_out)
    level.push_back(bounding_sphere(below.data() + begin, std::min(fan_out, below.size() - begin)));
  levels_.push_back(std::move(level));
}

}  // namespace integral_invariant
