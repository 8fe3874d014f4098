// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/base_meshes.h"

#include <algorithm>
#include <cmath>

#include "families/mesh_processing.h"
#include "sphere_meshes.h"
#include "support/shapes.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

/// Where the ray from the origin meets the surface, by bisection.
Vec3 on_ray(const Implicit& field, const Vec3& direction)
{
  double inside = 0, outside = 4;
  for (int i = 0; i < 60; ++i) {
    const double middle = (inside + outside) / 2;
    (field(direction * middle) < 0 ? inside : outside) = middle;
  }
  return direction * inside;
}

/// Vertex (i, j) of a grid of columns + 1 by rows + 1.
TriangleMesh grid(int columns, int rows, const std::function<Vec3(int i, int j)>& place)
{
  TriangleMesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) mesh.positions.push_back(place(i, j));
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      if (j % 2)
        mesh.triangles.insert(mesh.triangles.end(), {{a, d, c}, {a, b, d}});
      else
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {b, d, c}});
    }
  return mesh;
}

}  // namespace

TriangleMesh star_mesh(const Implicit& field, int vertices)
{
  constexpr int evening_passes = 12;
  TriangleMesh mesh = sphere_mesh(Meshing::irregular, vertices);
  for (Vec3& p : mesh.positions) p = on_ray(field, p);
  for (int pass = 0; pass < evening_passes; ++pass) {
    smooth(mesh, 0.5);
    for (Vec3& p : mesh.positions) p = on_ray(field, normalized(p));
  }
  return mesh;
}

TriangleMesh patch_mesh(const std::function<double(double, double)>& height, int vertices, std::uint32_t seed)
{
  const double row_height = std::sqrt(3.0) / 2;
  const int columns = int(std::sqrt(vertices * row_height)), rows = int(columns / row_height);
  const double edge = 2 / (columns + 0.5);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> jitter(-edge / 4, edge / 4);
  return grid(columns, rows, [&](int i, int j) {
    double x = -1 + edge * (i + 0.5 * (j % 2)), y = -1 + 2.0 * j / rows;
    if (i > 0 && j > 0 && i < columns && j < rows) {
      x += jitter(generator);
      y += jitter(generator);
    }
    return Vec3{x, y, height(x, y)};
  });
}

TriangleMesh line_mesh(const std::function<double(double, double)>& height, int vertices, double ratio)
{
  const int columns = int(std::sqrt(vertices * ratio)), rows = int(columns / ratio);
  return grid(columns, rows, [&](int i, int j) {
    const double x = -1 + 2 * (i + 0.5 * (j % 2)) / (columns + 0.5), y = -1 + 2.0 * j / rows;
    return Vec3{x, y, height(x, y)};
  });
}

TriangleMesh torus_mesh(double tube, int vertices)
{
  const int around_tube = int(std::sqrt(vertices * tube)), around_axis = 2 * (vertices / around_tube / 2);
  return test_support::torus(1, tube, around_axis, around_tube);
}

TriangleMesh half_of(const TriangleMesh& mesh)
{
  TriangleMesh half;
  std::vector<int> renumbered(mesh.positions.size(), -1);
  const auto is_kept = [&](int v) { return mesh.positions[std::size_t(v)].y >= 0; };
  for (Triangle t : mesh.triangles) {
    if (!std::all_of(t.begin(), t.end(), is_kept)) continue;
    for (int& v : t) {
      int& number = renumbered[std::size_t(v)];
      if (number < 0) {
        number = int(half.positions.size());
        half.positions.push_back(mesh.positions[std::size_t(v)]);
      }
      v = number;
    }
    half.triangles.push_back(t);
  }
  return half;
}

}  // namespace accuracy
