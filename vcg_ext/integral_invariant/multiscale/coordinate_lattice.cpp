// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: coordinate lattice. In: positions. Out: steps along the axes. Cost: under 10 ms.
#include "integral_invariant/multiscale/coordinate_lattice.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

namespace {

constexpr double nearly_all = 0.95;  ///< of the vertices: border and fan vertices may be elsewhere

std::vector<Vec3> sample_of(const std::vector<Vec3>& positions)
{
  constexpr std::size_t most = 20000;
  const std::size_t stride = positions.size() / most + 1;
  std::vector<Vec3> sample;
  for (std::size_t v = 0; v < positions.size(); v += stride) sample.push_back(positions[v]);
  return sample;
}

/// Places along one axis that are whole steps from `origin`.
struct Comb {
  double origin = 0, step = 0;

  bool has(double x) const
  {
    constexpr double slack = 0.02;  // of a step: single precision far from the origin
    const double t = (x - origin) / step;
    return step > 0 && std::abs(t - std::round(t)) < slack;
  }
  bool is_odd(double x) const { return std::llround((x - origin) / step) % 2 != 0; }
};

struct SharedValue {
  double value;
  std::size_t vertices;
};

/// The values that several vertices share, increasing.
std::vector<SharedValue> shared_values(std::vector<double> values)
{
  constexpr std::size_t least_vertices = 5;
  constexpr double precision = 1e-4;  // ē
  std::sort(values.begin(), values.end());
  std::vector<SharedValue> shared;
  for (std::size_t begin = 0, end = 0; begin < values.size(); begin = end) {
    while (end < values.size() && values[end] - values[begin] < precision) ++end;
    if (end - begin >= least_vertices) shared.push_back({values[begin], end - begin});
  }
  return shared;
}

/// Through the values that at least `least_vertices` share: steps are the smaller gaps between them. None where they
/// are few, or so near that rounding does not matter.
Comb comb_through(const std::vector<SharedValue>& shared, std::size_t least_vertices)
{
  constexpr std::size_t least_gaps = 3;
  constexpr double least_step = 0.05;  // ē
  std::vector<double> values, gaps;
  for (const SharedValue& s : shared) {
    if (s.vertices < least_vertices) continue;
    if (!values.empty()) gaps.push_back(s.value - values.back());
    values.push_back(s.value);
  }
  if (gaps.size() < least_gaps) return {};
  const auto smaller = gaps.begin() + std::ptrdiff_t(gaps.size() / 4);
  std::nth_element(gaps.begin(), smaller, gaps.end());
  return *smaller < least_step ? Comb{} : Comb{values[values.size() / 2], *smaller};
}

/// Few vertices share a value by chance, as where the surface turns back, and many in a plane across the axis: the comb
/// that most vertices are on counts.
Comb comb_along(const std::vector<Vec3>& sample, double Vec3::*axis)
{
  std::vector<double> values;
  for (const Vec3& p : sample) values.push_back(p.*axis);
  const std::vector<SharedValue> shared = shared_values(values);
  Comb best;
  std::ptrdiff_t most = 0;
  for (std::size_t least_vertices = 5; least_vertices < values.size(); least_vertices *= 2) {
    const Comb comb = comb_through(shared, least_vertices);
    const std::ptrdiff_t on = std::count_if(values.begin(), values.end(), [&](double x) { return comb.has(x); });
    if (on > most) {
      most = on;
      best = comb;
    }
  }
  return best;
}

/// Half way between two voxels along exactly one axis: of the eight parities only three occur.
bool is_binary_mask(const std::vector<Vec3>& sample, const std::array<Comb, 3>& combs)
{
  std::array<std::size_t, 8> counts{};
  for (const Vec3& p : sample)
    ++counts[std::size_t(combs[0].is_odd(p.x)) + 2 * std::size_t(combs[1].is_odd(p.y)) +
             4 * std::size_t(combs[2].is_odd(p.z))];
  std::sort(counts.begin(), counts.end());
  return double(counts[5] + counts[6] + counts[7]) > nearly_all * double(sample.size());
}

/// Whether the triangles lie in planes across the axes, as those of a box that was sampled on a lattice do: it has no
/// steps that are not its own.
bool is_boxy(const Surface& surface)
{
  const std::vector<Vec3>& p = surface.positions();
  std::size_t across_axis = 0;
  for (const Triangle& t : surface.triangles()) {
    constexpr double largest_extent = 1e-4;  // ē
    Box box;
    for (const int v : t) box.add(p[std::size_t(v)]);
    const Vec3 extent = box.high - box.low;
    across_axis += std::min({extent.x, extent.y, extent.z}) < largest_extent;
  }
  return double(across_axis) > nearly_all * double(surface.triangles().size());
}

/// The axis that most of the area looks along: heights are along it. A scanner's columns are a lattice across it.
std::size_t height_axis(const Surface& surface)
{
  const std::vector<Vec3>& p = surface.positions();
  Vec3 seen;
  for (const Triangle& t : surface.triangles()) {
    const Vec3 area = cross(p[std::size_t(t[1])] - p[std::size_t(t[0])], p[std::size_t(t[2])] - p[std::size_t(t[0])]);
    seen += {std::abs(area.x), std::abs(area.y), std::abs(area.z)};
  }
  return seen.x > std::max(seen.y, seen.z) ? 0 : seen.y > seen.z ? 1 : 2;
}

}  // namespace

double CoordinateLattice::variance_along(const Vec3& normal) const
{
  constexpr double of_uniform = 1.0 / 12;
  const Vec3 n = axes.vector(normal);
  return squared_norm(Vec3{n.x * steps[0], n.y * steps[1], n.z * steps[2]}) * of_uniform;
}

CoordinateLattice find_coordinate_lattice(const Surface& surface)
{
  const std::vector<Vec3> sample = sample_of(surface.positions());
  const std::array<Comb, 3> combs{comb_along(sample, &Vec3::x), comb_along(sample, &Vec3::y),
                                  comb_along(sample, &Vec3::z)};
  std::array<std::size_t, 3> on_axis{};
  std::size_t on_all = 0, on_two = 0;
  for (const Vec3& p : sample) {
    const std::array<bool, 3> on{combs[0].has(p.x), combs[1].has(p.y), combs[2].has(p.z)};
    for (std::size_t a = 0; a < 3; ++a) on_axis[a] += on[a];
    const int count = int(on[0]) + int(on[1]) + int(on[2]);
    on_all += count == 3;
    on_two += count >= 2;
  }
  const auto are_nearly_all = [&](std::size_t count) { return double(count) > nearly_all * double(sample.size()); };

  CoordinateLattice lattice;
  const auto axes = std::count_if(on_axis.begin(), on_axis.end(), are_nearly_all);
  if (are_nearly_all(on_all)) {
    if (is_boxy(surface)) return lattice;
    const double steps_a_voxel = is_binary_mask(sample, combs) ? 2 : 1;
    for (std::size_t a = 0; a < 3; ++a) lattice.steps[a] = combs[a].step * steps_a_voxel;
  } else if (axes == 1) {
    const std::size_t a = height_axis(surface);
    if (are_nearly_all(on_axis[a])) lattice.steps[a] = combs[a].step;
  } else if (axes == 0) {
    lattice.is_from_grid = are_nearly_all(on_two);
  }
  return lattice;
}

}  // namespace integral_invariant
