// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/read_mesh.h"

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

}  // namespace

TriangleMesh read_mesh(ByteReader& bytes)
{
  TriangleMesh mesh = read_shape(bytes);
  const std::uint32_t noise = bytes.below(64);
  if (noise % 2) mesh = test_support::with_normal_noise(std::move(mesh), noise * 0.005, noise);
  for (std::uint32_t defects = bytes.below(16); defects > 3; --defects) add_defect(bytes, mesh);
  move(bytes, mesh);
  return mesh;
}

}  // namespace fuzz
