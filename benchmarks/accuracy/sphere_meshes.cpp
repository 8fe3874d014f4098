// SPDX-License-Identifier: GPL-3.0-or-later
// The convex hull of points on a sphere is their Delaunay triangulation there; CGAL builds it.
#include "sphere_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include "integral_invariant/support/pi.h"
#include "support/shapes.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

/// Vertices in the order of `points`, triangles sorted: CGAL promises neither order.
TriangleMesh hull(const std::vector<Vec3>& points)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  std::vector<Kernel::Point_3> input;
  std::map<std::array<double, 3>, int> index;
  for (const Vec3& p : points) {
    index.emplace(std::array<double, 3>{p.x, p.y, p.z}, int(input.size()));
    input.emplace_back(p.x, p.y, p.z);
  }
  Mesh surface;
  CGAL::convex_hull_3(input.begin(), input.end(), surface);

  TriangleMesh mesh;
  mesh.positions = points;
  for (const auto f : surface.faces()) {
    Triangle t{};
    int corner = 0;
    for (const auto v : surface.vertices_around_face(surface.halfedge(f))) {
      const Kernel::Point_3& p = surface.point(v);
      t[corner++] = index.at({p.x(), p.y(), p.z()});
    }
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    mesh.triangles.push_back(t);
  }
  std::sort(mesh.triangles.begin(), mesh.triangles.end());
  return mesh;
}

/// `points` and more, to `count` of them, by dart throwing: none nearer than `distance(p)`. Cost O(tries): cells of the
/// largest distance, and where it is larger than a cell there is to be no point.
template <class Distance>
std::vector<Vec3> scattered(int count, const Distance& distance, double cell, std::vector<Vec3> points = {})
{
  std::mt19937 generator(7);
  std::normal_distribution<double> gauss;
  std::map<std::array<int, 3>, std::vector<Vec3>> cells;
  const auto home_of = [&](const Vec3& p) {
    return std::array<int, 3>{int(std::floor(p.x / cell)), int(std::floor(p.y / cell)), int(std::floor(p.z / cell))};
  };
  for (const Vec3& p : points) cells[home_of(p)].push_back(p);
  const auto is_free = [&](const Vec3& p, const std::array<int, 3>& home) {
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz) {
          const auto it = cells.find({home[0] + dx, home[1] + dy, home[2] + dz});
          if (it == cells.end()) continue;
          for (const Vec3& q : it->second)
            if (norm(p - q) < distance(p)) return false;
        }
    return true;
  };
  for (int tries = 0; int(points.size()) < count && tries < 400 * count; ++tries) {
    const Vec3 p = normalized({gauss(generator), gauss(generator), gauss(generator)});
    const std::array<int, 3> home = home_of(p);
    if (distance(p) > cell || !is_free(p, home)) continue;
    cells[home].push_back(p);
    points.push_back(p);
  }
  return points;
}

std::vector<Vec3> with_twins(std::vector<Vec3> points, double distance)
{
  std::mt19937 generator(11);
  std::normal_distribution<double> gauss;
  for (std::size_t i = 0, n = points.size(); i < n; i += 3) {
    const Vec3 away = normalized(cross(points[i], {gauss(generator), gauss(generator), gauss(generator)}));
    points.push_back(normalized(points[i] + away * distance));
  }
  return points;
}

}  // namespace

std::string name_of(Meshing meshing)
{
  switch (meshing) {
    case Meshing::irregular:
      return "irregular";
    case Meshing::graded:
      return "graded";
    case Meshing::slivers:
      return "slivers";
    default:
      return "regular";
  }
}

TriangleMesh sphere_mesh(Meshing meshing, int vertices)
{
  const double spacing = std::sqrt(4 * pi / vertices);
  switch (meshing) {
    case Meshing::irregular:
      return hull(scattered(
          vertices, [&](const Vec3&) { return 0.6 * spacing; }, spacing));
    case Meshing::graded: {
      const auto distance = [&](const Vec3& p) { return 0.4 * spacing * std::pow(6.0, (p.z + 1) / 2); };
      return hull(scattered(vertices, distance, 2.4 * spacing));
    }
    default:
      break;
  }
  int levels = 0;
  while (10 * (1 << (2 * levels + 2)) + 2 < 1.5 * vertices) ++levels;
  const TriangleMesh regular = test_support::icosphere(levels);
  return meshing == Meshing::regular ? regular : hull(with_twins(regular.positions, 0.15 * spacing));
}

TriangleMesh sphere_mesh_with_hole(int vertices, double angle, int rim)
{
  const double spacing = std::sqrt(4 * pi / vertices);
  std::vector<Vec3> points;
  for (int j = 0; j < rim; ++j) {
    const double azimuth = 2 * pi * j / rim;
    points.push_back({std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)});
  }
  const auto distance = [&](const Vec3& p) { return p.z < std::cos(angle) ? 0.6 * spacing : 3.0; };
  TriangleMesh mesh = hull(scattered(vertices, distance, spacing, points));
  const auto is_rim = [&](int v) { return v < rim; };
  auto& triangles = mesh.triangles;
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                 [&](const Triangle& t) { return std::all_of(t.begin(), t.end(), is_rim); }),
                  triangles.end());
  return mesh;
}

}  // namespace accuracy
