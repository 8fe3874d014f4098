// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace test_support {

using integral_invariant::cross;
using integral_invariant::dot;
using integral_invariant::norm;
using integral_invariant::normalized;
using integral_invariant::Triangle;

namespace {

constexpr double pi = 3.14159265358979323846;

/// Merges vertices that stand at the same place, up to `tolerance`.
TriangleMesh welded(const TriangleMesh& mesh, double tolerance)
{
  std::map<std::array<long long, 3>, int> index;
  std::vector<int> new_index;
  TriangleMesh result;
  for (const Vec3& p : mesh.positions) {
    const std::array<long long, 3> key{std::llround(p.x / tolerance), std::llround(p.y / tolerance),
                                       std::llround(p.z / tolerance)};
    const auto [it, added] = index.emplace(key, int(result.positions.size()));
    if (added) result.positions.push_back(p);
    new_index.push_back(it->second);
  }
  for (const Triangle& t : mesh.triangles) {
    const Triangle moved{new_index[t[0]], new_index[t[1]], new_index[t[2]]};
    if (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0]) result.triangles.push_back(moved);
  }
  return result;
}

/// Grid of (nu + 1) × (nv + 1) points over the parallelogram origin + s·u + t·v, oriented along u × v.
TriangleMesh parallelogram(Vec3 origin, Vec3 u, Vec3 v, int nu, int nv)
{
  TriangleMesh mesh;
  for (int i = 0; i <= nu; ++i)
    for (int j = 0; j <= nv; ++j) mesh.positions.push_back(origin + u * (double(i) / nu) + v * (double(j) / nv));
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const int a = i * (nv + 1) + j, b = a + nv + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  return mesh;
}

}  // namespace

TriangleMesh icosphere(int levels, double radius, Vec3 centre)
{
  const double t = (1 + std::sqrt(5.0)) / 2;
  TriangleMesh mesh;
  mesh.positions = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                    {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (Vec3& p : mesh.positions) p = normalized(p);
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middle;
    const auto split = [&](int a, int b) {
      const auto [it, added] = middle.emplace(std::minmax(a, b), int(mesh.positions.size()));
      if (added) mesh.positions.push_back(normalized(mesh.positions[a] + mesh.positions[b]));
      return it->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& f : mesh.triangles) {
      const int ab = split(f[0], f[1]), bc = split(f[1], f[2]), ca = split(f[2], f[0]);
      finer.insert(finer.end(), {{f[0], ab, ca}, {f[1], bc, ab}, {f[2], ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return translated(scaled(std::move(mesh), radius), centre);
}

TriangleMesh bumpy_sphere(int levels)
{
  TriangleMesh mesh = icosphere(levels);
  for (Vec3& p : mesh.positions) p *= 1 + 0.1 * std::sin(3 * p.x + 1) * std::sin(3 * p.y) + 0.1 * std::sin(3 * p.z);
  return mesh;
}

TriangleMesh torus(double major_radius, double tube_radius, int nu, int nv)
{
  TriangleMesh mesh;
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      // Every other row is shifted by half a step: nearly equilateral triangles.
      const double u = 2 * pi * i / nu, v = 2 * pi * (j + 0.5 * (i % 2)) / nv;
      const double rho = major_radius + tube_radius * std::cos(v);
      mesh.positions.push_back({rho * std::cos(u), rho * std::sin(u), tube_radius * std::sin(v)});
    }
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const int i1 = (i + 1) % nu, j1 = (j + 1) % nv;
      const int a = i * nv + j, b = i1 * nv + j, c = i1 * nv + j1, d = i * nv + j1;
      if (i % 2) {
        mesh.triangles.push_back({a, c, d});
        mesh.triangles.push_back({a, b, c});
      } else {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      }
    }
  return mesh;
}

TriangleMesh box(double a, double b, double c, double step)
{
  const auto cells = [step](double length) { return std::max(1, int(std::lround(length / step))); };
  const int na = cells(a), nb = cells(b), nc = cells(c);
  const Vec3 x{a, 0, 0}, y{0, b, 0}, z{0, 0, c}, o{};
  TriangleMesh mesh = parallelogram(o, y, x, nb, na);
  mesh = joined(std::move(mesh), parallelogram(z, x, y, na, nb));
  mesh = joined(std::move(mesh), parallelogram(o, x, z, na, nc));
  mesh = joined(std::move(mesh), parallelogram(y, z, x, nc, na));
  mesh = joined(std::move(mesh), parallelogram(o, z, y, nc, nb));
  mesh = joined(std::move(mesh), parallelogram(x, y, z, nb, nc));
  return welded(mesh, std::min({a / na, b / nb, c / nc}) * 1e-3);
}

TriangleMesh cylinder(double radius, double height, double step)
{
  const int around = std::max(8, int(std::lround(2 * pi * radius / step)));
  const int along = std::max(1, int(std::lround(height / step)));
  TriangleMesh mesh = parallelogram({0, 0, -height / 2}, {1, 0, 0}, {0, 0, height}, around, along);
  for (Vec3& p : mesh.positions) p = {radius * std::cos(2 * pi * p.x), radius * std::sin(2 * pi * p.x), p.z};
  const int rings = std::max(1, int(std::lround(radius / step)));
  for (const double side : {-1.0, 1.0}) {
    TriangleMesh cap = parallelogram({}, {1, 0, 0}, {0, 1, 0}, rings, around);
    for (Vec3& p : cap.positions)
      p = {radius * p.x * std::cos(2 * pi * p.y), radius * p.x * std::sin(2 * pi * p.y), side * height / 2};
    mesh = joined(std::move(mesh), side > 0 ? std::move(cap) : flipped(std::move(cap)));
  }
  return welded(mesh, 1e-4 * std::min(step, 2 * pi * radius / (around * rings)));
}

TriangleMesh with_normal_noise(TriangleMesh mesh, double sigma, std::uint32_t seed)
{
  const std::vector<Vec3> normals = vertex_normals(mesh);
  std::mt19937 generator(seed);
  std::normal_distribution<double> gauss(0, sigma);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) mesh.positions[v] += normals[v] * gauss(generator);
  return mesh;
}

TriangleMesh with_tangential_jitter(TriangleMesh mesh, double amount, std::uint32_t seed)
{
  const std::vector<Vec3> normals = vertex_normals(mesh);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    Vec3 move;
    do move = {uniform(generator), uniform(generator), uniform(generator)};
    while (squared_norm(move) > 1);
    mesh.positions[v] += (move - normals[v] * dot(move, normals[v])) * amount;
  }
  return mesh;
}

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b)
{
  const int offset = int(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

TriangleMesh translated(TriangleMesh mesh, Vec3 by)
{
  for (Vec3& p : mesh.positions) p += by;
  return mesh;
}

TriangleMesh scaled(TriangleMesh mesh, double factor)
{
  for (Vec3& p : mesh.positions) p *= factor;
  return mesh;
}

Vec3 rotated(const Vec3& v, const Vec3& axis, double angle)
{
  return v * std::cos(angle) + cross(axis, v) * std::sin(angle) + axis * (dot(axis, v) * (1 - std::cos(angle)));
}

TriangleMesh rotated(TriangleMesh mesh, Vec3 axis, double angle)
{
  for (Vec3& p : mesh.positions) p = rotated(p, axis, angle);
  return mesh;
}

TriangleMesh flipped(TriangleMesh mesh)
{
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

double torus_curvature_around_axis(double major_radius, double tube_radius, double v)
{
  return std::cos(v) / (major_radius + tube_radius * std::cos(v));
}

double average_edge_length(const TriangleMesh& mesh)
{
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
  double sum = 0;
  for (const auto& [a, b] : edges) sum += norm(mesh.positions[a] - mesh.positions[b]);
  return sum / double(edges.size());
}

double bounding_box_diagonal(const TriangleMesh& mesh)
{
  Vec3 low = mesh.positions.front(), high = low;
  for (const Vec3& p : mesh.positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return norm(high - low);
}

std::vector<Vec3> vertex_normals(const TriangleMesh& mesh)
{
  std::vector<Vec3> normals(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.positions[t[0]];
    const Vec3 area = cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
    for (const int v : t) normals[v] += area;
  }
  for (Vec3& n : normals) n = normalized(n, {});
  return normals;
}

}  // namespace test_support
