// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: which scales points and spheres belong to, as inner loops on arrays; for their rules see
// clip.h.
#include "integral_invariant/moments/surface/kernels/scale_search.h"

#include <cmath>

#include "integral_invariant/support/simd.h"

namespace integral_invariant {

namespace {

constexpr std::size_t lanes = kernel_lanes;

}  // namespace

void SphereColumns::clear()
{
  x.clear(), y.clear(), z.clear(), radius.clear();
  size_ = 0;
}

void SphereColumns::push(const Vec3& centre, double r)
{
  x.push_back(centre.x), y.push_back(centre.y), z.push_back(centre.z), radius.push_back(r);
  ++size_;
}

void SphereColumns::take(const SphereColumns& from, const std::uint32_t* list, std::size_t count)
{
  clear();
  for (std::size_t i = 0; i < count; ++i)
    push({from.x[list[i]], from.y[list[i]], from.z[list[i]]}, from.radius[list[i]]);
  pad();
}

void SphereColumns::pad()
{
  const std::size_t full = (size_ + lanes - 1) / lanes * lanes;
  x.resize(full, 0), y.resize(full, 0), z.resize(full, 0), radius.resize(full, 0);
}

II_VECTOR_CLONES
void find_scale_ranges(const SphereColumns& spheres, const Vec3& centre, double extent,
                       const std::vector<double>& radii, std::uint8_t* least, std::uint8_t* largest)
{
  const double *x = spheres.x.data(), *y = spheres.y.data(), *z = spheres.z.data(), *radius = spheres.radius.data();
  const double* limits = radii.data();
  const std::size_t scales = radii.size(), count = spheres.x.size();
  const double cx = centre.x, cy = centre.y, cz = centre.z;
  for (std::size_t group = 0; group < count; group += lanes) {
    double low[lanes], high[lanes];
    std::int64_t below[lanes] = {}, within[lanes] = {};
#pragma GCC unroll 1
    for (std::size_t j = 0; j < lanes; ++j) {
      const double dx = x[group + j] - cx, dy = y[group + j] - cy, dz = z[group + j] - cz;
      const double distance = std::sqrt(dx * dx + dy * dy + dz * dz), reach = radius[group + j] + extent;
      low[j] = distance - reach;
      high[j] = distance + reach;
    }
    for (std::size_t k = 0; k < scales; ++k)
#pragma GCC unroll 1
      for (std::size_t j = 0; j < lanes; ++j) {
        below[j] += limits[k] < low[j] ? 1 : 0;
        within[j] += limits[k] < high[j] ? 1 : 0;
      }
#pragma GCC unroll 1
    for (std::size_t j = 0; j < lanes; ++j) {
      least[group + j] = std::uint8_t(below[j]);
      largest[group + j] = std::uint8_t(within[j]);
    }
  }
}

II_VECTOR_CLONES
void find_scales(const double* x, const double* y, const double* z, const std::vector<std::uint32_t>& groups,
                 const Vec3& centre, const std::vector<double>& squared_radii, std::uint8_t* scale)
{
  const double* limits = squared_radii.data();
  const std::size_t scales = squared_radii.size();
  const double cx = centre.x, cy = centre.y, cz = centre.z;
  for (const std::uint32_t g : groups) {
    const std::size_t group = std::size_t(g) * lanes;
    double d2[lanes];
    std::int64_t beyond[lanes] = {};
    for (std::size_t j = 0; j < lanes; ++j) {
      const double dx = x[group + j] - cx, dy = y[group + j] - cy, dz = z[group + j] - cz;
      d2[j] = dx * dx + dy * dy + dz * dz;
    }
    for (std::size_t k = 0; k < scales; ++k)
      for (std::size_t j = 0; j < lanes; ++j) beyond[j] += d2[j] > limits[k] ? 1 : 0;
    for (std::size_t j = 0; j < lanes; ++j) scale[group + j] = std::uint8_t(beyond[j]);
  }
}

}  // namespace integral_invariant
