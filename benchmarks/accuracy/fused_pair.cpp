// SPDX-License-Identifier: GPL-3.0-or-later
#include "fused_pair.h"

#include <cmath>

#include "implicit_curvature.h"
#include "integral_invariant/support/pi.h"
#include "sphere_meshes.h"
#include "support/shapes.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

constexpr double scale = 8, hole_angle = 0.4, neck_length = 0.8, neck_tangent = 0.5;

using RadialFunction = std::function<double(const Vec3&)>;

/// Star-shaped surface with a hole about the +z pole; its rim are the first vertices.
TruthMesh star_with_hole(const RadialFunction& radius, double angle, int rim, int vertices)
{
  TruthMesh truth;
  truth.mesh = sphere_mesh_with_hole(vertices, angle, rim);
  for (Vec3& p : truth.mesh.positions) p *= radius(p);
  measure_truth(truth, [&](const Vec3& p) { return norm(p) - radius(normalized(p)); });
  return truth;
}

/// The small part is turned upside down (half a turn about x) and lifted above the large one.
Vec3 turned(const Vec3& v) { return {v.x, -v.y, -v.z}; }

/// Unit tangent of a star-shaped surface at p along its meridian, away from the +z pole.
Vec3 away_from_pole(const RadialFunction& radius, const Vec3& p)
{
  constexpr double step = 1e-4;
  const Vec3 direction = normalized(p), across = normalized(cross({0, 0, 1}, direction));
  const Vec3 ahead = normalized(direction + cross(across, direction) * step);
  return normalized(ahead * radius(ahead) - direction * radius(direction));
}

/// Rows of the neck: cubic Hermite curves between the rims, tangent to both surfaces.
std::vector<Vec3> neck_rows(const std::vector<Vec3>& low, const std::vector<Vec3>& low_tangent,
                            const std::vector<Vec3>& high, const std::vector<Vec3>& high_tangent, int rows)
{
  std::vector<Vec3> places;
  for (int row = 1; row <= rows; ++row) {
    const double t = row / (rows + 1.0), t2 = t * t, t3 = t2 * t;
    for (std::size_t j = 0; j < low.size(); ++j)
      places.push_back(low[j] * (2 * t3 - 3 * t2 + 1) + low_tangent[j] * ((t3 - 2 * t2 + t) * neck_tangent) +
                       high[j] * (3 * t2 - 2 * t3) + high_tangent[j] * ((t3 - t2) * neck_tangent));
  }
  return places;
}

void append(TruthMesh& all, const TruthMesh& part)
{
  all.mesh = test_support::joined(all.mesh, part.mesh);
  all.normal.insert(all.normal.end(), part.normal.begin(), part.normal.end());
  all.dir_max.insert(all.dir_max.end(), part.dir_max.begin(), part.dir_max.end());
  all.kappa_max.insert(all.kappa_max.end(), part.kappa_max.begin(), part.kappa_max.end());
  all.kappa_min.insert(all.kappa_min.end(), part.kappa_min.begin(), part.kappa_min.end());
}

/// Vertices [begin, end) that lie farther than `distance` beyond the rim of the hole about `pole`.
std::vector<std::uint32_t> beyond(const TriangleMesh& mesh, std::size_t begin, std::size_t end, const Vec3& rim_centre,
                                  double distance)
{
  std::vector<std::uint32_t> found;
  for (std::size_t v = begin; v < end; ++v)
    if (norm(mesh.positions[v] - rim_centre) > distance) found.push_back(std::uint32_t(v));
  return found;
}

}  // namespace

TruthMesh fused_pair(const RadialFunction& radius, int vertices, std::size_t judged)
{
  const double spacing = std::sqrt(4 * pi / vertices), rim_radius = std::sin(hole_angle);
  const int rim = int(std::lround(2 * pi * rim_radius / spacing)), rows = int(std::lround(neck_length / spacing));
  TruthMesh small = star_with_hole(radius, hole_angle, rim, vertices);
  TruthMesh large = star_with_hole(radius, std::asin(rim_radius / scale), rim, int(vertices * scale * scale));

  std::vector<Vec3> low, low_tangent, high, high_tangent;
  const double lift = large.mesh.positions[0].z * scale + neck_length + small.mesh.positions[0].z;
  for (int j = 0; j < rim; ++j) {
    const Vec3& below = large.mesh.positions[j];
    const Vec3& above = small.mesh.positions[(rim - j) % rim];  // turning reverses the order around the axis
    low.push_back(below * scale);
    low_tangent.push_back(-away_from_pole(radius, below));
    high.push_back(turned(above) + Vec3{0, 0, lift});
    high_tangent.push_back(turned(away_from_pole(radius, above)));
  }
  large.mesh = test_support::scaled(large.mesh, scale);
  for (double& k : large.kappa_max) k /= scale;
  for (double& k : large.kappa_min) k /= scale;
  for (std::vector<Vec3>* vectors : {&small.mesh.positions, &small.normal, &small.dir_max})
    for (Vec3& v : *vectors) v = turned(v);
  small.mesh = test_support::translated(small.mesh, {0, 0, lift});

  TruthMesh truth = large, neck;
  const std::size_t large_end = truth.mesh.positions.size();
  neck.mesh.positions = neck_rows(low, low_tangent, high, high_tangent, rows);
  const std::size_t neck_count = neck.mesh.positions.size(), small_begin = large_end + neck_count;
  neck.normal.resize(neck_count);
  neck.dir_max.assign(neck_count, {1, 0, 0});
  neck.kappa_max.assign(neck_count, 0);
  neck.kappa_min.assign(neck_count, 0);
  append(truth, neck);
  append(truth, small);
  const auto index = [&](int row, int j) {  // row 0 is the large part's rim, the last one the small part's
    j %= rim;
    if (row == 0) return j;
    return row <= rows ? int(large_end) + (row - 1) * rim + j : int(small_begin) + (rim - j) % rim;
  };
  for (int row = 0; row <= rows; ++row)
    for (int j = 0; j < rim; ++j) {
      truth.mesh.triangles.push_back({index(row, j), index(row, j + 1), index(row + 1, j + 1)});
      truth.mesh.triangles.push_back({index(row, j), index(row + 1, j + 1), index(row + 1, j)});
    }
  const std::vector<Vec3> normals = test_support::vertex_normals(truth.mesh);
  std::copy(normals.begin() + std::ptrdiff_t(large_end), normals.begin() + std::ptrdiff_t(small_begin),
            truth.normal.begin() + std::ptrdiff_t(large_end));

  const std::size_t end = truth.mesh.positions.size();
  set_reference(truth, 0, large_end);
  set_reference(truth, large_end, end);
  set_reference(truth, small_begin, end);
  const double distance = rim_radius + 5 * spacing;
  draw_judged(truth, beyond(truth.mesh, small_begin, end, {0, 0, high[0].z}, distance), judged / 2);
  draw_judged(truth, beyond(truth.mesh, 0, large_end, {0, 0, low[0].z}, distance), judged / 2);
  return truth;
}

}  // namespace accuracy
