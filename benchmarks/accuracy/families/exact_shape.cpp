// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/exact_shape.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "support/shapes.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

constexpr std::size_t judged_vertices = 800;

/// Vertices that can be judged: in a triangle, neither on a boundary nor next to one.
std::vector<bool> inner_vertices(const TriangleMesh& mesh)
{
  std::set<std::pair<int, int>> open;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      const int a = t[c], b = t[(c + 1) % 3];
      if (!open.erase({b, a})) open.insert({a, b});
    }
  std::vector<bool> on_rim(mesh.positions.size()), inner(mesh.positions.size());
  for (const auto& [a, b] : open) on_rim[std::size_t(a)] = on_rim[std::size_t(b)] = true;
  for (const Triangle& t : mesh.triangles)
    for (const int v : t) inner[std::size_t(v)] = true;
  for (const Triangle& t : mesh.triangles)
    if (std::any_of(t.begin(), t.end(), [&](int v) { return on_rim[std::size_t(v)]; }))
      for (const int v : t) inner[std::size_t(v)] = false;
  return inner;
}

}  // namespace

Vec3 gradient_of(const Implicit& f, const Vec3& p)
{
  constexpr double h = 1e-5;  // central differences: errors of h² and of rounding / h are both about 1e-10
  return Vec3{f(p + Vec3{h, 0, 0}) - f(p - Vec3{h, 0, 0}), f(p + Vec3{0, h, 0}) - f(p - Vec3{0, h, 0}),
              f(p + Vec3{0, 0, h}) - f(p - Vec3{0, 0, h})} *
         (1 / (2 * h));
}

Vec3 project(const Implicit& field, const Vec3& p)
{
  // Newton's step onto the zero set, then a step along it towards the foot of the perpendicular.
  constexpr int steps = 25;
  constexpr double small = 1e-12;
  Vec3 q = p;
  for (int i = 0; i < steps; ++i) {
    const Vec3 g = gradient_of(field, q), n = normalized(g);
    const Vec3 onto = g * (-field(q) / std::max(squared_norm(g), small));
    const Vec3 off = p - (q + onto), along = off - n * dot(n, off);
    const Vec3 step = onto + along * 0.7;  // full steps overshoot where the surface bends towards p
    q += step;
    if (squared_norm(step) < small * small) break;
  }
  return q;
}

TruthMesh judge_at_projections(const ExactShape& shape, TriangleMesh mesh)
{
  constexpr double least_seam_distance = 3;  // edges
  const double edge = test_support::average_edge_length(mesh);
  const std::vector<bool> inner = inner_vertices(mesh);
  const std::size_t n = mesh.positions.size();
  std::vector<std::uint32_t> candidates;
  for (std::uint32_t v = 0; v < n; ++v)
    if (inner[v] && (!shape.seam_distance || shape.seam_distance(mesh.positions[v]) > least_seam_distance * edge))
      candidates.push_back(v);

  TruthMesh truth, exact;
  truth.mesh = std::move(mesh);
  draw_judged(truth, candidates, judged_vertices);
  for (const std::uint32_t v : truth.judged)
    exact.mesh.positions.push_back(project(shape.field, truth.mesh.positions[v]));
  measure_truth(exact, shape.field);
  truth.normal.resize(n);
  truth.kappa_max.resize(n);
  truth.kappa_min.resize(n);
  truth.dir_max.resize(n);
  truth.reference.assign(n, exact.reference.empty() ? 1 : exact.reference.front());
  for (std::size_t i = 0; i < truth.judged.size(); ++i) {
    const std::uint32_t v = truth.judged[i];
    truth.normal[v] = exact.normal[i];
    truth.kappa_max[v] = exact.kappa_max[i];
    truth.kappa_min[v] = exact.kappa_min[i];
    truth.dir_max[v] = exact.dir_max[i];
  }
  return truth;
}

}  // namespace accuracy
