// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/read_mesh.h"

#include <cmath>
#include <utility>

#include "support/shapes.h"

namespace fuzz {

namespace {

using integral_invariant::Triangle;
using integral_invariant::TriangleMesh;
using integral_invariant::Vec3;

Vec3 read_point(ByteReader& bytes) { return {bytes.between(-1, 1), bytes.between(-1, 1), bytes.between(-1, 1)}; }

std::int32_t some_vertex(ByteReader& bytes, const TriangleMesh& mesh)
{
  return std::int32_t(bytes.below(std::uint32_t(mesh.positions.size())));
}

Triangle& some_triangle(ByteReader& bytes, TriangleMesh& mesh)
{
  return mesh.triangles[bytes.below(std::uint32_t(mesh.triangles.size()))];
}

TriangleMesh loose_triangles(ByteReader& bytes)
{
  TriangleMesh mesh;
  const std::uint32_t vertices = 1 + bytes.below(20), triangles = bytes.below(30);
  for (std::uint32_t v = 0; v < vertices; ++v) mesh.positions.push_back(read_point(bytes));
  for (std::uint32_t t = 0; t < triangles; ++t)
    mesh.triangles.push_back({some_vertex(bytes, mesh), some_vertex(bytes, mesh), some_vertex(bytes, mesh)});
  return mesh;
}

/// An open sheet over a grid of unit squares.
TriangleMesh sheet(ByteReader& bytes)
{
  TriangleMesh mesh;
  const std::int32_t columns = 2 + std::int32_t(bytes.below(7)), rows = 2 + std::int32_t(bytes.below(7));
  const double height = bytes.between(0, 2);
  for (std::int32_t j = 0; j < rows; ++j)
    for (std::int32_t i = 0; i < columns; ++i)
      mesh.positions.push_back({double(i), double(j), height * std::sin(i + 2.0 * j)});
  for (std::int32_t j = 0; j + 1 < rows; ++j)
    for (std::int32_t i = 0; i + 1 < columns; ++i) {
      const std::int32_t a = j * columns + i, b = a + 1, c = a + columns, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  return mesh;
}

TriangleMesh read_shape(ByteReader& bytes)
{
  switch (bytes.below(8)) {
    case 0:
      return test_support::icosphere(0);
    case 1:
      return test_support::icosphere(1);
    case 2:
      return test_support::icosphere(2);
    case 3:
      return test_support::torus(2, 0.6, 12, 5);
    case 4:
      return test_support::box(1, 1, 1, bytes.between(0.3, 1));
    case 5:
      return sheet(bytes);
    case 6:
      return test_support::joined(test_support::icosphere(1),
                                  test_support::translated(test_support::icosphere(1), read_point(bytes)));
    default:
      return loose_triangles(bytes);
  }
}

void add_defect(ByteReader& bytes, TriangleMesh& mesh)
{
  Vec3& p = mesh.positions[std::size_t(some_vertex(bytes, mesh))];
  const std::uint32_t defect = bytes.below(16);
  if (defect < 6 || mesh.triangles.empty()) {
    switch (defect) {
      case 0:
        p.x = bytes.any_real();
        return;
      case 1:
        p = {bytes.any_real(), bytes.any_real(), bytes.any_real()};
        return;
      case 2:
        p = mesh.positions[std::size_t(some_vertex(bytes, mesh))];
        return;
      case 3:
        p += read_point(bytes) * bytes.magnitude();
        return;
      case 4:
        mesh.positions.push_back(read_point(bytes));
        return;
      default:
        p += read_point(bytes);
        return;
    }
  }
  Triangle& t = some_triangle(bytes, mesh);
  switch (defect) {
    case 6:
      std::swap(t[0], t[1]);
      return;
    case 7:
      t[2] = t[bytes.below(2)];
      return;
    case 8:
      t[bytes.below(3)] = bytes.any_int();
      return;
    case 9:
      t[bytes.below(3)] = some_vertex(bytes, mesh);
      return;
    case 10:
      t = mesh.triangles.back();
      mesh.triangles.pop_back();
      return;
    case 11:
      mesh.triangles.push_back(Triangle(t));
      return;
    case 12:
      mesh.triangles.push_back({t[1], t[0], t[2]});
      return;
    case 13:
      mesh.triangles.push_back({t[0], t[1], some_vertex(bytes, mesh)});
      return;
    case 14:
      for (Triangle& other : mesh.triangles) std::swap(other[0], other[1]);
      return;
    default:
      mesh.positions.push_back(p);
      t[0] = std::int32_t(mesh.positions.size()) - 1;
      return;
  }
}

void move(ByteReader& bytes, TriangleMesh& mesh)
{
  Vec3 scale{1, 1, 1}, offset;
  switch (bytes.below(8)) {
    case 0:
      scale = Vec3{1, 1, 1} * bytes.magnitude();
      break;
    case 1:
      scale = {bytes.magnitude(), bytes.unit(), 1};
      break;
    case 2:
      offset = read_point(bytes) * bytes.magnitude();
      break;
    case 3:
      scale.z = 0;
      break;
    default:
      return;
  }
  for (Vec3& p : mesh.positions) p = Vec3{p.x * scale.x, p.y * scale.y, p.z * scale.z} + offset;
  if (bytes.flag())
    for (Vec3& p : mesh.positions)
      for (double* x : {&p.x, &p.y, &p.z})
        if (std::abs(*x) < double(std::numeric_limits<float>::max())) *x = double(float(*x));
}

/// Every triangle, or some, with vertices of its own: soups, split normals, seams of texture.
void split(ByteReader& bytes, bool all, TriangleMesh& mesh)
{
  const std::vector<Vec3> shared = mesh.positions;
  const double rounding = bytes.flag() ? 6e-8 : 0;  // of files in single precision
  for (Triangle& t : mesh.triangles) {
    if (!all && bytes.flag()) continue;
    for (std::int32_t& corner : t) {
      if (corner < 0 || std::size_t(corner) >= shared.size()) continue;
      mesh.positions.push_back(shared[std::size_t(corner)] * (1 + rounding * double(mesh.positions.size() % 3)));
      corner = std::int32_t(mesh.positions.size()) - 1;
    }
  }
}

/// A copy of another size at one of the vertices.
void add_copy_of_another_size(ByteReader& bytes, TriangleMesh& mesh)
{
  const double size = std::pow(10.0, bytes.between(-4, 4));
  const Vec3 place = mesh.positions[std::size_t(some_vertex(bytes, mesh))];
  const std::size_t vertices = mesh.positions.size(), triangles = mesh.triangles.size();
  for (std::size_t v = 0; v < vertices; ++v) mesh.positions.push_back(mesh.positions[v] * size + place);
  for (std::size_t t = 0; t < triangles; ++t) {
    Triangle copy = mesh.triangles[t];
    for (std::int32_t& corner : copy)
      if (corner >= 0 && std::size_t(corner) < vertices) corner += std::int32_t(vertices);
    mesh.triangles.push_back(copy);
  }
}

/// Long and thin triangles: the mesh stretched, or vertices drawn close to each other.
void make_slivers(ByteReader& bytes, TriangleMesh& mesh)
{
  if (bytes.flag()) {
    const double aspect = std::pow(10.0, bytes.between(0, 4));
    for (Vec3& p : mesh.positions) p.x *= aspect;
    return;
  }
  const double closeness = std::pow(10.0, bytes.between(-6, 0));
  for (Triangle& t : mesh.triangles) {
    const std::int32_t a = t[0], b = t[1];
    const auto count = std::int32_t(mesh.positions.size());
    if (a < 0 || a >= count || b < 0 || b >= count || bytes.below(4) > 0) continue;
    Vec3& p = mesh.positions[std::size_t(a)];
    p += (mesh.positions[std::size_t(b)] - p) * (1 - closeness);
  }
}

/// What meshes of every day have: nothing is joined, sizes differ by thousands, triangles are long.
void arrange(ByteReader& bytes, TriangleMesh& mesh)
{
  switch (bytes.below(12)) {
    case 1:
      return split(bytes, true, mesh);
    case 2:
      return split(bytes, false, mesh);
    case 3:
      return add_copy_of_another_size(bytes, mesh);
    case 4:
      return make_slivers(bytes, mesh);
    case 5:
      add_copy_of_another_size(bytes, mesh);
      return split(bytes, true, mesh);
    case 6:
      make_slivers(bytes, mesh);
      return split(bytes, true, mesh);
    case 7:
      make_slivers(bytes, mesh);
      return add_copy_of_another_size(bytes, mesh);
    default:
      return;
  }
}

}  // namespace

TriangleMesh read_mesh(ByteReader& bytes)
{
  TriangleMesh mesh = read_shape(bytes);
  const std::uint32_t noise = bytes.below(64);
  if (noise % 2) mesh = test_support::with_normal_noise(std::move(mesh), noise * 0.005, noise);
  for (std::uint32_t defects = bytes.below(16); defects > 3; --defects) add_defect(bytes, mesh);
  move(bytes, mesh);
  arrange(bytes, mesh);
  return mesh;
}

}  // namespace fuzz
