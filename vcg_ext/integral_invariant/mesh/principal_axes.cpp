// SPDX-License-Identifier: GPL-3.0-or-later
// Before the first stage: axes that turn with the mesh. In: the caller's mesh. Out: its principal axes. Cost: 0.1 µs a
// triangle.
#include "integral_invariant/mesh/principal_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "integral_invariant/support/orderless_sums.h"
#include "integral_invariant/support/symmetric3.h"

namespace integral_invariant {

namespace {

/// A triangle's area, at its centroid.
struct Mass {
  double area;
  Vec3 centroid;
};

/// The mesh in coordinates within -1 and 1, so that no product overflows and sums can be bounded.
class ScaledMesh {
 public:
  ScaledMesh(const TriangleMesh& mesh, Execution& execution) : mesh_(mesh), execution_(execution)
  {
    Box box;
    for_each_in_order(mesh.triangles.size(), execution, [&](std::size_t i) {
      if (is_proper(mesh.triangles[i], mesh.positions))
        for (const std::int32_t v : mesh.triangles[i]) box.add(mesh.positions[std::size_t(v)]);
    });
    const Vec3 extent = box.high - box.low;
    const double size = std::max({extent.x, extent.y, extent.z});
    centre_ = box.low + extent * 0.5;
    if (size > 0 && std::isnormal(1 / size)) inverse_size_ = 1 / size;
  }

  bool is_empty() const { return inverse_size_ == 0; }
  Vec3 position(std::int32_t v) const { return (mesh_.positions[std::size_t(v)] - centre_) * inverse_size_; }
  const TriangleMesh& mesh() const { return mesh_; }

  /// Over all triangles, of the N terms that `terms_of` makes of a mass.
  template <std::size_t N, class TermsOf>
  std::array<double, N> sums(const TermsOf& terms_of) const
  {
    constexpr std::size_t grain = 8192;
    constexpr double largest_term = 16;  // areas are under 2, distances from the centroid too
    const OrderlessSums<N> none(largest_term, mesh_.triangles.size());
    std::vector<OrderlessSums<N>> of_worker(std::size_t(execution_.threads()), none);
    parallel_step(mesh_.triangles.size(), grain, execution_, [&](std::size_t begin, std::size_t end, int worker) {
      for (std::size_t i = begin; i < end; ++i)
        if (is_proper(mesh_.triangles[i], mesh_.positions))
          of_worker[std::size_t(worker)].add(terms_of(mass_of(mesh_.triangles[i])));
    });
    OrderlessSums<N> total = none;
    for (const OrderlessSums<N>& sums : of_worker) total += sums;
    return total.values();
  }

 private:
  /// The same to the last bit whichever corner comes first and whichever side is up.
  Mass mass_of(Triangle t) const
  {
    std::sort(t.begin(), t.end(), [&](std::int32_t a, std::int32_t b) {
      return precedes(std::uint32_t(a), std::uint32_t(b), mesh_.positions);
    });
    const Vec3 a = position(t[0]), b = position(t[1]), c = position(t[2]);
    return {norm(cross(b - a, c - a)) / 2, (a + b + c) * (1.0 / 3)};
  }

  const TriangleMesh& mesh_;
  Execution& execution_;
  Vec3 centre_;
  double inverse_size_ = 0;
};

/// Centroid and covariance of the masses.
struct Spread {
  double area;
  Vec3 centroid;
  Symmetric3 covariance;
};

Spread spread_of(const ScaledMesh& mesh)
{
  const auto [m, x, y, z, xx, xy, xz, yy, yz, zz] = mesh.sums<10>([](const Mass& mass) {
    const Vec3& p = mass.centroid;
    const Vec3 first = p * mass.area;
    return std::array<double, 10>{mass.area,     first.x,       first.y,       first.z,       first.x * p.x,
                                  first.x * p.y, first.x * p.z, first.y * p.y, first.y * p.z, first.z * p.z};
  });
  if (!(m > 0)) return {};
  const Vec3 centroid = Vec3{x, y, z} * (1 / m);
  return {m, centroid, Symmetric3{xx, xy, xz, yy, yz, zz} * (1 / m) - outer(centroid)};
}

/// The largest of what `offset_of` makes of the vertices that triangles use; of equal ones, that of the vertex whose
/// coordinates come first.
template <class OffsetOf>
Vec3 farthest_offset(const ScaledMesh& mesh, Execution& execution, const OffsetOf& offset_of)
{
  const std::vector<Vec3>& positions = mesh.mesh().positions;
  std::optional<std::uint32_t> best;
  double largest = 0;
  Vec3 offset;
  for_each_in_order(mesh.mesh().triangles.size(), execution, [&](std::size_t i) {
    const Triangle& t = mesh.mesh().triangles[i];
    if (!is_proper(t, positions)) return;
    for (const std::int32_t v : t) {
      const Vec3 candidate = offset_of(mesh.position(v));
      const double square = squared_norm(candidate);
      if (best && (square < largest || (square == largest && !precedes(std::uint32_t(v), *best, positions)))) continue;
      best = std::uint32_t(v);
      largest = square;
      offset = candidate;
    }
  });
  return offset;
}

Axes right_handed(const Vec3& x, const Vec3& y)
{
  const Vec3 first = normalized(x, {1, 0, 0});
  const Vec3 second = normalized(y - first * dot(first, y), any_orthogonal(first));
  return {first, second, cross(first, second)};
}

/// From the vertices, where the spread does not tell all three axes. `known`: the one that it tells, or zero.
Axes axes_of_vertices(const ScaledMesh& mesh, const Vec3& centroid, const Vec3& known, Execution& execution)
{
  const auto across = [](const Vec3& a, const Vec3& axis) { return a - axis * dot(a, axis); };
  Vec3 first = known;
  if (squared_norm(known) == 0)
    first = normalized(farthest_offset(mesh, execution, [&](const Vec3& p) { return p - centroid; }));
  return right_handed(first,
                      farthest_offset(mesh, execution, [&](const Vec3& p) { return across(p - centroid, first); }));
}

}  // namespace

Axes principal_axes(const TriangleMesh& mesh, Execution& execution)
{
  const ScaledMesh scaled(mesh, execution);
  if (scaled.is_empty()) return {};
  const Spread spread = spread_of(scaled);
  if (!(spread.area > 0)) return {};
  const EigenDecomposition3 principal = eigen_decomposition(spread.covariance);
  const std::array<double, 3>& variance = principal.values;
  // Rounding of single precision turns axes whose variances are nearer than that by more than a thousandth.
  constexpr double least_gap = 1e-6;
  const double gap = least_gap * variance[2];
  const bool tells_largest = variance[2] - variance[1] > gap, tells_smallest = variance[1] - variance[0] > gap;

  std::array<Vec3, 3> axes = principal.vectors;
  const std::array<double, 3> skewness = scaled.sums<3>([&](const Mass& mass) {
    std::array<double, 3> terms;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = dot(mass.centroid - spread.centroid, axes[i]);
      terms[i] = mass.area * x * x * x;
    }
    return terms;
  });
  for (std::size_t i = 0; i < 3; ++i)
    if (skewness[i] < 0) axes[i] = -axes[i];
  if (tells_largest && tells_smallest) return right_handed(axes[2], axes[1]);
  const Vec3 known = tells_largest ? axes[2] : tells_smallest ? axes[0] : Vec3{};
  return axes_of_vertices(scaled, spread.centroid, known, execution);
}

}  // namespace integral_invariant
