// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/volume.h"

#include <algorithm>
#include <cmath>

namespace accuracy {

using namespace integral_invariant;

namespace {

constexpr double largest_distance = 3;  // voxels

template <class Body>
void for_each_voxel(const Volume& volume, const Body& body)
{
  for (int z = 0; z < volume.size[2]; ++z)
    for (int y = 0; y < volume.size[1]; ++y)
      for (int x = 0; x < volume.size[0]; ++x) body(x, y, z);
}

}  // namespace

Volume sample(const ExactShape& shape, const Vec3& spacing, std::mt19937& generator)
{
  std::uniform_real_distribution<double> shift(0, 1);
  Volume v;
  v.spacing = spacing;
  const Vec3 extent = shape.domain.high - shape.domain.low;
  v.size = {int(extent.x / spacing.x), int(extent.y / spacing.y), int(extent.z / spacing.z)};
  const double x = shift(generator), y = shift(generator), z = shift(generator);
  v.origin = shape.domain.low + Vec3{spacing.x * x, spacing.y * y, spacing.z * z};
  v.value.resize(std::size_t(v.size[0]) * std::size_t(v.size[1]) * std::size_t(v.size[2]));
  const double unit = std::min({spacing.x, spacing.y, spacing.z});
  for_each_voxel(v, [&](int i, int j, int k) {
    const Vec3 p = v.place(i, j, k);
    const double slope = norm(gradient_of(shape.field, p));
    v.at(i, j, k) = std::clamp(shape.field(p) / (slope * unit + 1e-12), -largest_distance, largest_distance);
  });
  return v;
}

void make_binary(Volume& volume)
{
  for (double& value : volume.value) value = value < 0 ? -1 : 1;
}

void blur(Volume& volume)
{
  const std::array<std::array<int, 3>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const Volume before = volume;
    const auto& d = axes[axis];
    const int last = volume.size[axis] - 1;
    for_each_voxel(volume, [&](int x, int y, int z) {
      const int here = std::array<int, 3>{x, y, z}[axis], down = here > 0, up = here < last;
      volume.at(x, y, z) = before.at(x, y, z) / 2 + before.at(x - down * d[0], y - down * d[1], z - down * d[2]) / 4 +
                           before.at(x + up * d[0], y + up * d[1], z + up * d[2]) / 4;
    });
  }
}

void add_white(Volume& volume, double level, std::mt19937& generator)
{
  // Only near the surface: noise on the clamped values would make no surface there at these levels.
  std::normal_distribution<double> gauss(0, level);
  for (double& value : volume.value)
    if (std::abs(value) < largest_distance) value += gauss(generator);
}

Volume distance_to_points(const std::vector<Vec3>& points, const std::vector<Vec3>& normals, double width,
                          const Volume& sign)
{
  constexpr double reach = 3;  // widths
  Volume distance = sign;
  Volume weight = sign, sum = sign;
  std::fill(weight.value.begin(), weight.value.end(), 0);
  std::fill(sum.value.begin(), sum.value.end(), 0);
  const Vec3 h = sign.spacing;
  const double unit = std::min({h.x, h.y, h.z});
  const auto first = [&](double from, double step) {
    return std::max(0, int(std::ceil((from - reach * width) / step)));
  };
  const auto last = [&](double from, double step, int size) {
    return std::min(size - 1, int(std::floor((from + reach * width) / step)));
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 at = points[i] - sign.origin;
    for (int z = first(at.z, h.z); z <= last(at.z, h.z, sign.size[2]); ++z)
      for (int y = first(at.y, h.y); y <= last(at.y, h.y, sign.size[1]); ++y)
        for (int x = first(at.x, h.x); x <= last(at.x, h.x, sign.size[0]); ++x) {
          const Vec3 off = sign.place(x, y, z) - points[i];
          const double w = std::exp(-squared_norm(off) / (2 * width * width));
          weight.at(x, y, z) += w;
          sum.at(x, y, z) += w * dot(off, normals[i]) / unit;
        }
  }
  const double least_weight = std::exp(-reach * reach / 2);
  for (std::size_t i = 0; i < distance.value.size(); ++i) {
    if (weight.value[i] > least_weight) distance.value[i] = sum.value[i] / weight.value[i];
  }
  return distance;
}

}  // namespace accuracy
