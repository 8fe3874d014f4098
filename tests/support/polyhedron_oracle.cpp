// SPDX-License-Identifier: GPL-3.0-or-later
// Ball moments of a closed polyhedron, by arithmetic that shares nothing with the engines.
#include "support/polyhedron_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace test_support {

namespace {

using integral_invariant::BallMoments;
using integral_invariant::TriangleMesh;
using integral_invariant::Vec3;
using Real = long double;

struct V {
  Real x = 0, y = 0, z = 0;
};
V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
V operator*(V a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
Real dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
V cross(V a, V b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Real length(V a) { return std::sqrt(dot(a, a)); }

/// 1, x, y, z, xx, xy, xz, yy, yz, zz
using Ten = std::array<Real, 10>;
void add(Ten& sum, const Ten& b, Real s)
{
  for (int i = 0; i < 10; ++i) sum[i] += b[i] * s;
}
void add_first(Ten& sum, V v, Real s)
{
  sum[1] += v.x * s;
  sum[2] += v.y * s;
  sum[3] += v.z * s;
}
void add_second(Ten& sum, V a, V b, Real s)
{
  sum[4] += a.x * b.x * s;
  sum[5] += (a.x * b.y + a.y * b.x) / 2 * s;
  sum[6] += (a.x * b.z + a.z * b.x) / 2 * s;
  sum[7] += a.y * b.y * s;
  sum[8] += (a.y * b.z + a.z * b.y) / 2 * s;
  sum[9] += a.z * b.z * s;
}

/// The plane at distance h along the unit vector n, and the ball.
struct Plane {
  V n;
  Real h, r;

  /// ∫_0^R f(h n + ρ e) min(1, (r/x)^{d+3}) ρ dρ · h/(d+3) with x = √(h² + ρ²).
  Ten radial(V e, Real reach) const
  {
    const Real rim = h * h < r * r ? std::sqrt(r * r - h * h) : 0;
    const Real in = std::min(reach, rim);
    const Real in2 = in * in, in3 = in2 * in, in4 = in2 * in2;
    Real v = in2 / 2, m0 = in2 / 2, m1 = in3 / 3, s0 = in2 / 2, s1 = in3 / 3, s2 = in4 / 4;
    if (reach > rim) {
      const Real x = std::sqrt(h * h + reach * reach), x0 = std::sqrt(h * h + rim * rim);
      const Real r4 = r * r * r * r, g = std::abs(h);
      v += r * r * r * (1 / x0 - 1 / x);
      m0 += r4 * (1 / (x0 * x0) - 1 / (x * x)) / 2;
      m1 += r4 * ((rim / (x0 * x0) - reach / (x * x)) / 2 + (std::atan(reach / g) - std::atan(rim / g)) / (2 * g));
      s0 += r4 * r * (1 / (x0 * x0 * x0) - 1 / (x * x * x)) / 3;
      s1 += r4 * r * (std::pow(reach / x, 3) - std::pow(rim / x0, 3)) / (3 * h * h);
      s2 += r4 * r * ((1 / x0 - 1 / x) - h * h * (1 / (x0 * x0 * x0) - 1 / (x * x * x)) / 3);
    }
    Ten t{};
    t[0] = v * h / 3;
    add_first(t, n, m0 * h * h / 4);
    add_first(t, e, m1 * h / 4);
    add_second(t, n, n, s0 * h * h * h / 5);
    add_second(t, n, e, 2 * s1 * h * h / 5);
    add_second(t, e, e, s2 * h / 5);
    return t;
  }
};

/// The sector between the foot and an edge; `distance` is the signed distance of the foot from the edge's line.
struct Edge {
  const Plane& plane;
  V foot_point, along;  ///< nearest point of the line to the foot, and its unit direction
  Real distance;

  Ten at(Real s) const
  {
    const Real reach2 = distance * distance + s * s, reach = std::sqrt(reach2);
    Ten t = plane.radial((foot_point + along * s) * (1 / reach), reach);
    for (Real& value : t) value *= distance / reach2;
    return t;
  }

  Ten gauss(Real a, Real b) const
  {
    static const Real node[5] = {0.1488743389816312108848L, 0.4333953941292471907993L, 0.6794095682990244062343L,
                                 0.8650633666889845107321L, 0.9739065285171717200780L};
    static const Real weight[5] = {0.2955242247147528701739L, 0.2692667193099963550912L, 0.2190863625159820439955L,
                                   0.1494513491505805931458L, 0.0666713443086881375936L};
    Ten sum{};
    const Real mid = (a + b) / 2, half = (b - a) / 2;
    for (int i = 0; i < 5; ++i) {
      add(sum, at(mid - half * node[i]), weight[i] * half);
      add(sum, at(mid + half * node[i]), weight[i] * half);
    }
    return sum;
  }

  void adaptive(Real a, Real b, const Ten& whole, int depth, Ten& sum) const
  {
    const Real mid = (a + b) / 2;
    const Ten left = gauss(a, mid), right = gauss(mid, b);
    Real error = 0, r = plane.r;
    const Real unit[3] = {r * r * r, r * r * r * r, r * r * r * r * r};
    for (int i = 0; i < 10; ++i)
      error = std::max(error, std::abs(left[i] + right[i] - whole[i]) / unit[i == 0 ? 0 : i < 4 ? 1 : 2]);
    if (depth == 0 || error < 1e-15L) {
      add(sum, left, 1);
      add(sum, right, 1);
      return;
    }
    adaptive(a, mid, left, depth - 1, sum);
    adaptive(mid, b, right, depth - 1, sum);
  }
};

void add_edge(const Plane& plane, V a, V b, Ten& sum)
{
  const V foot = plane.n * plane.h, along = (b - a) * (1 / length(b - a));
  const Real from = dot(a - foot, along), to = dot(b - foot, along);
  const V nearest = (a - foot) - along * from;
  const Real distance = dot(cross(nearest, along), plane.n);
  if (std::abs(distance) < 1e-17L) return;
  const Edge edge{plane, nearest, along, distance};
  // Split where the edge enters and leaves the ball, and at the point nearest to the foot.
  std::array<Real, 5> cuts = {from, to, from, from, from};
  int count = 2;
  const Real inside2 = plane.r * plane.r - plane.h * plane.h - distance * distance;
  for (const Real s : {Real(0), inside2 > 0 ? std::sqrt(inside2) : 0, inside2 > 0 ? -std::sqrt(inside2) : 0})
    if (s > from && s < to) cuts[std::size_t(count++)] = s;
  std::sort(cuts.begin(), cuts.begin() + count);
  for (int i = 0; i + 1 < count; ++i)
    if (cuts[i + 1] > cuts[i]) edge.adaptive(cuts[i], cuts[i + 1], edge.gauss(cuts[i], cuts[i + 1]), 60, sum);
}

}  // namespace

BallMoments polyhedron_moments(const TriangleMesh& mesh, const Vec3& centre, double radius)
{
  Ten sum{};
  for (const auto& t : mesh.triangles) {
    V v[3];
    for (int i = 0; i < 3; ++i) {
      const Vec3& p = mesh.positions[std::size_t(t[i])];
      v[i] = V{p.x, p.y, p.z} - V{centre.x, centre.y, centre.z};
    }
    const V area = cross(v[1] - v[0], v[2] - v[0]);
    const Real doubled = length(area);
    if (!(doubled > 0)) continue;
    const V n = area * (1 / doubled);
    const Plane plane{n, dot(n, v[0]), radius};
    if (std::abs(plane.h) < 1e-17L * radius) continue;
    for (int i = 0; i < 3; ++i) add_edge(plane, v[i], v[(i + 1) % 3], sum);
  }
  BallMoments m;
  m.volume = double(sum[0]);
  m.first = {double(sum[1]), double(sum[2]), double(sum[3])};
  m.second = {double(sum[4]), double(sum[5]), double(sum[6]), double(sum[7]), double(sum[8]), double(sum[9])};
  return m;
}

double moment_distance(const BallMoments& a, const BallMoments& b, double radius)
{
  const double r3 = radius * radius * radius;
  const auto s = a.second - b.second;
  double worst = std::abs(a.volume - b.volume) / r3;
  worst = std::max(worst, norm(a.first - b.first) / (r3 * radius));
  for (const double entry : {s.xx, s.xy, s.xz, s.yy, s.yz, s.zz})
    worst = std::max(worst, std::abs(entry) / (r3 * radius * radius));
  return worst;
}

}  // namespace test_support
