// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>

#include "fused_pair.h"
#include "implicit_curvature.h"
#include "integral_invariant/support/pi.h"
#include "support/shapes.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

constexpr int star_vertices = 10242, pair_vertices = 1000;
constexpr std::size_t judged_vertices = 800;

/// Radius of a star-shaped surface in the direction of a unit vector.
using RadialFunction = std::function<double(const Vec3&)>;

double ellipsoid_radius(const Vec3& d)
{
  return 1 / std::sqrt(d.x * d.x / (1.5 * 1.5) + d.y * d.y + d.z * d.z / (0.7 * 0.7));
}

/// Sphere with a spherical harmonic of degree 6 and order 4.
double harmonic_radius(const Vec3& d)
{
  const double x2 = d.x * d.x, y2 = d.y * d.y;
  return 1 + 0.05 * (x2 * x2 - 6 * x2 * y2 + y2 * y2) * (11 * d.z * d.z - 1);
}

Vec3 spiral_direction(int i, int count)
{
  const double z = 1 - (2 * i + 1.0) / count, angle = pi * (3 - std::sqrt(5.0)) * i;
  return {std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z};
}

double bumps(const Vec3& d, int count, double height, double width, double min_x)
{
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const Vec3 centre = spiral_direction(i, count);
    const double squared = squared_norm(d - centre) / (width * width);
    if (centre.x > min_x && squared < 80) sum += height * std::exp(-squared / 2);
  }
  return sum;
}

/// Twelve wide bumps all around, and small ones on one half.
double two_scale_radius(const Vec3& d) { return 1 + bumps(d, 12, 0.15, 0.35, -2) + bumps(d, 100, 0.02, 0.1, 0.1); }

TruthMesh star_shape(const RadialFunction& radius, Meshing meshing, int vertices)
{
  TruthMesh truth;
  truth.mesh = sphere_mesh(meshing, vertices);
  for (Vec3& p : truth.mesh.positions) p *= radius(p);
  measure_truth(truth, [&](const Vec3& p) { return norm(p) - radius(normalized(p)); });
  return truth;
}

TruthMesh torus()
{
  TruthMesh truth;
  truth.mesh = test_support::torus(1, 0.4, 160, 64);
  measure_truth(truth, [](const Vec3& p) { return std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.4; });
  return truth;
}

/// Cylinder closed by half spheres: the sphere mesh stretched along its meridians.
TruthMesh capsule()
{
  constexpr double radius = 0.6, half_length = 0.6, length = pi * radius + 2 * half_length;
  TruthMesh truth;
  truth.mesh = sphere_mesh(Meshing::regular, star_vertices);
  for (Vec3& p : truth.mesh.positions) {
    const double from_pole = std::acos(std::clamp(std::abs(p.z), 0.0, 1.0)) / pi * length;
    const double angle = std::min(from_pole / radius, pi / 2);
    const double side = p.z < 0 ? -1 : 1;
    const double height = half_length + radius * std::cos(angle) - std::max(0.0, from_pole - radius * pi / 2);
    const double azimuth = std::atan2(p.y, p.x), rho = radius * std::sin(angle);
    p = {rho * std::cos(azimuth), rho * std::sin(azimuth), side * height};
  }
  // The curvature jumps at the seam, so differences are taken on the vertex's own side.
  const auto surface = [](const Vec3& p, bool capped) {
    return capped ? norm({p.x, p.y, std::abs(p.z) - half_length}) - radius : std::hypot(p.x, p.y) - radius;
  };
  TruthMesh sides[2];
  for (const bool capped : {false, true}) {
    sides[capped].mesh = truth.mesh;
    measure_truth(
        sides[capped], [&](const Vec3& p) { return surface(p, capped); }, 1e-3);
  }
  truth = sides[0];
  for (std::size_t v = 0; v < truth.mesh.positions.size(); ++v)
    if (std::abs(truth.mesh.positions[v].z) > half_length) {
      truth.normal[v] = sides[1].normal[v];
      truth.kappa_max[v] = sides[1].kappa_max[v];
      truth.kappa_min[v] = sides[1].kappa_min[v];
      truth.dir_max[v] = sides[1].dir_max[v];
    }
  set_reference(truth, 0, truth.mesh.positions.size());
  return truth;
}

/// Open patch z = height(x, y) over the square [−1, 1]², rows of equilateral triangles; the solid is below.
TruthMesh patch(const std::function<double(double, double)>& height)
{
  constexpr int columns = 94, rows = 108;
  TruthMesh truth;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const double x = -1 + 2 * (i + 0.5 * (j % 2)) / (columns + 0.5), y = -1 + 2.0 * j / rows;
      truth.mesh.positions.push_back({x, y, height(x, y)});
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      if (j % 2)
        truth.mesh.triangles.insert(truth.mesh.triangles.end(), {{a, d, c}, {a, b, d}});
      else
        truth.mesh.triangles.insert(truth.mesh.triangles.end(), {{a, b, c}, {b, d, c}});
    }
  measure_truth(truth, [&](const Vec3& p) { return p.z - height(p.x, p.y); });
  return truth;
}

TruthMesh unjudged_shape(const std::string& name, Meshing meshing)
{
  if (name == "sphere") return star_shape([](const Vec3&) { return 1.0; }, meshing, star_vertices);
  if (name == "ellipsoid") return star_shape(ellipsoid_radius, meshing, star_vertices);
  if (name == "harmonic") return star_shape(harmonic_radius, meshing, star_vertices);
  if (name == "two_scale") return star_shape(two_scale_radius, meshing, star_vertices);
  if (name == "torus") return torus();
  if (name == "capsule") return capsule();
  if (name == "saddle") return patch([](double x, double y) { return (x * x - y * y) / 2; });
  if (name == "quadric") return patch([](double x, double y) { return -0.8 * x * x - 0.3 * y * y; });
  if (name == "pair_1_8") return fused_pair(harmonic_radius, pair_vertices, judged_vertices);
  throw std::invalid_argument("no shape is called " + name);
}

}  // namespace

std::vector<std::string> shape_names()
{
  return {"sphere", "torus", "ellipsoid", "harmonic", "two_scale", "capsule", "saddle", "quadric", "pair_1_8"};
}

bool is_star_shaped(const std::string& name)
{
  return name == "sphere" || name == "ellipsoid" || name == "harmonic" || name == "two_scale";
}

TruthMesh make_shape(const std::string& name, Meshing meshing)
{
  TruthMesh truth = unjudged_shape(name, meshing);
  if (!truth.judged.empty()) return truth;
  std::vector<std::uint32_t> all(truth.mesh.positions.size());
  std::iota(all.begin(), all.end(), 0u);
  draw_judged(truth, all, judged_vertices);
  return truth;
}

}  // namespace accuracy
