// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <cmath>
#include <map>
#include <random>
#include <utility>

#include "integral_invariant/support/pi.h"
#include "support/feature_shapes.h"

namespace line_benchmark {

using integral_invariant::cross;
using integral_invariant::pi;
using integral_invariant::squared_norm;

namespace {

TriangleMesh in_edges(const TriangleMesh& mesh)
{
  return test_support::scaled(mesh, 1 / test_support::average_edge_length(mesh));
}

/// Points of the square ±half on rows of equilateral triangles of side 1.
TriangleMesh lattice(double half)
{
  const double row_height = std::sqrt(0.75);
  const int rows = int(2 * half / row_height), columns = int(2 * half);
  TriangleMesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) mesh.positions.push_back({-half + i + 0.5 * (j % 2), -half + j * row_height, 0});
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      if (j % 2 == 0) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({b, d, c});
      } else {
        mesh.triangles.push_back({a, d, c});
        mesh.triangles.push_back({a, b, d});
      }
    }
  return mesh;
}

Shape star(const std::string& name, const TriangleMesh& mesh, const Vec3& half_axes)
{
  Shape shape;
  shape.name = name;
  shape.mesh = in_edges(mesh);
  const double unit = 1 / test_support::average_edge_length(mesh);
  shape.position = [=](double s, double t) {
    return Vec3{half_axes.x * std::sin(s) * std::cos(t) * unit, half_axes.y * std::sin(s) * std::sin(t) * unit,
                half_axes.z * std::cos(s) * unit};
  };
  constexpr double pole = 1e-3;  // where the parameters are singular
  shape.s_begin = pole;
  shape.s_end = pi - pole;
  shape.t_end = 2 * pi;
  return shape;
}

/// Σ over the vertices within three correlation lengths of weight times value.
std::vector<double> averaged(const std::vector<Vec3>& positions, const std::vector<double>& values, double length)
{
  using Cell = std::array<int, 3>;
  const double reach = 3 * length;
  const auto cell_of = [&](const Vec3& p) {
    return Cell{int(std::floor(p.x / reach)), int(std::floor(p.y / reach)), int(std::floor(p.z / reach))};
  };
  std::map<Cell, std::vector<std::size_t>> cells;
  for (std::size_t v = 0; v < positions.size(); ++v) cells[cell_of(positions[v])].push_back(v);
  std::vector<double> sums(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Cell c = cell_of(positions[v]);
    for (int i = 0; i < 27; ++i) {
      const auto found = cells.find({c[0] + i % 3 - 1, c[1] + i / 3 % 3 - 1, c[2] + i / 9 - 1});
      if (found == cells.end()) continue;
      for (const std::size_t q : found->second)
        sums[v] += values[q] * std::exp(-squared_norm(positions[q] - positions[v]) / (2 * length * length));
    }
  }
  return sums;
}

}  // namespace

Shape torus_shape()
{
  constexpr double major = 3, minor = 1;
  const TriangleMesh mesh = test_support::torus(major, minor, 280, 80);
  const double unit = 1 / test_support::average_edge_length(mesh);
  Shape shape;
  shape.name = "torus";
  shape.mesh = in_edges(mesh);
  shape.position = [=](double s, double t) {
    const double rho = (major + minor * std::cos(t)) * unit;
    return Vec3{rho * std::cos(s), rho * std::sin(s), minor * std::sin(t) * unit};
  };
  shape.s_end = shape.t_end = 2 * pi;
  return shape;
}

Shape ellipsoid_shape()
{
  const Vec3 axes{2, 1.4, 0.8};
  return star("ellipsoid", test_support::ellipsoid(5, axes), axes);
}

Shape sphere_shape() { return star("sphere", test_support::icosphere(5), {1, 1, 1}); }

Shape height_field(const std::string& name, const std::function<double(double, double)>& height)
{
  constexpr double half = 48, margin = 6;
  Shape shape;
  shape.name = name;
  shape.margin = margin;
  shape.mesh = lattice(half);
  for (Vec3& p : shape.mesh.positions) p.z = height(p.x, p.y);
  shape.position = [=](double s, double t) { return Vec3{s, t, height(s, t)}; };
  shape.s_begin = shape.t_begin = -half + margin;
  shape.s_end = shape.t_end = half - margin;
  return shape;
}

TriangleMesh with_noise(const TriangleMesh& mesh, double sigma, double correlation, std::uint32_t seed)
{
  if (!(sigma > 0)) return mesh;
  if (!(correlation > 0)) return test_support::with_normal_noise(mesh, sigma, seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> noise(mesh.positions.size());
  for (double& value : noise) value = normal(random);
  noise = averaged(mesh.positions, noise, correlation);
  double squares = 0;
  for (const double value : noise) squares += value * value;
  const double scale = sigma / std::sqrt(squares / double(noise.size()));
  TriangleMesh noisy = mesh;
  const std::vector<Vec3> normals = test_support::vertex_normals(mesh);
  for (std::size_t v = 0; v < noise.size(); ++v) noisy.positions[v] += normals[v] * (noise[v] * scale);
  return noisy;
}

}  // namespace line_benchmark
