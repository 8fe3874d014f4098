// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/shape_catalogue.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "families/base_meshes.h"
#include "integral_invariant/support/pi.h"
#include "support/shapes.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

double uniform(std::mt19937& generator, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(generator);
}

Box cube(double half) { return {{-half, -half, -half}, {half, half, half}}; }

ExactShape star(std::string name, std::string group, Implicit field, double half_domain)
{
  const auto mesh = [field](int vertices) { return star_mesh(field, vertices); };
  return {std::move(name), std::move(group), field, cube(half_domain), mesh, {}, false};
}

/// A sum of plane waves in random directions, each with a random wavenumber between the limits.
struct Waves {
  struct Wave {
    Vec3 k;
    double phase;
  };
  std::vector<Wave> waves;

  Waves(int count, double least, double largest, std::mt19937& generator)
  {
    std::normal_distribution<double> gauss;
    for (int i = 0; i < count; ++i) {
      const Vec3 direction = normalized({gauss(generator), gauss(generator), gauss(generator)});
      waves.push_back({direction * uniform(generator, least, largest), uniform(generator, 0, 2 * pi)});
    }
  }
  double operator()(const Vec3& p) const
  {
    double sum = 0;
    for (const Wave& w : waves) sum += std::cos(dot(w.k, p) + w.phase);
    return sum;
  }
};

ExactShape sphere()
{
  return star(
      "sphere", "smooth", [](const Vec3& p) { return norm(p) - 1; }, 1.4);
}

ExactShape ellipsoid(std::mt19937& generator)
{
  const double a = uniform(generator, 0.6, 0.9), b = uniform(generator, 1.1, 1.5);
  return star(
      "ellipsoid", "smooth",
      [=](const Vec3& p) {
        return norm({p.x / b, p.y, p.z / a}) - 1;
      },
      1.9);
}

ExactShape torus(std::mt19937& generator, bool half)
{
  const double tube = uniform(generator, 0.3, 0.45), reach = 1.4 + tube;
  const Implicit field = [=](const Vec3& p) { return std::hypot(std::hypot(p.x, p.y) - 1, p.z) - tube; };
  const Box domain{{-reach, half ? 0 : -reach, -0.4 - tube}, {reach, reach, 0.4 + tube}};
  const auto mesh = [=](int vertices) {
    return half ? half_of(torus_mesh(tube, 2 * vertices)) : torus_mesh(tube, vertices);
  };
  return {half ? "half_torus" : "torus", half ? "open" : "smooth", field, domain, mesh, {}, false};
}

/// Cassini's ovals turned about x: two lobes that have grown together.
ExactShape peanut(std::mt19937& generator)
{
  const double c = 0.8, b = uniform(generator, 0.93, 1.1);
  const auto field = [=](const Vec3& p) { return std::sqrt(norm(p - Vec3{c, 0, 0}) * norm(p + Vec3{c, 0, 0})) - b; };
  return star("peanut", "smooth", field, 1.9);
}

ExactShape bumpy_sphere(std::mt19937& generator)
{
  const Waves waves(6, 5, 8, generator);
  return star(
      "bumpy_sphere", "bumpy", [=](const Vec3& p) { return norm(p) - 1 - 0.02 * waves(normalized(p)); }, 1.6);
}

/// A Goursat surface: a rounded cube with a dimple in each face.
ExactShape goursat(std::mt19937& generator)
{
  const double dimple = uniform(generator, 0.2, 0.6);
  const auto field = [=](const Vec3& p) {
    const double x = p.x * p.x, y = p.y * p.y, z = p.z * p.z;
    return (x * x + y * y + z * z - dimple * (x + y + z) - 1) / 4;
  };
  return star("goursat", "bumpy", field, 1.7);
}

/// A sphere with the bumps of Schoen's gyroid.
ExactShape gyroid_sphere(std::mt19937& generator)
{
  const double k = uniform(generator, 4, 7);
  const auto field = [=](const Vec3& p) {
    const Vec3 d = normalized(p) * k;
    return norm(p) - 1 -
           0.04 * (std::sin(d.x) * std::cos(d.y) + std::sin(d.y) * std::cos(d.z) + std::sin(d.z) * std::cos(d.x));
  };
  return star("gyroid_sphere", "bumpy", field, 1.6);
}

/// Block whose edges and corners are rounded by one radius: planes, cylinders, spheres.
ExactShape fillet_block(std::mt19937& generator)
{
  const double r = uniform(generator, 0.2, 0.35);
  const Vec3 core{uniform(generator, 0.5, 0.8), uniform(generator, 0.4, 0.6), uniform(generator, 0.4, 0.6)};
  const auto field = [=](const Vec3& p) {
    const Vec3 out{std::abs(p.x) - core.x, std::abs(p.y) - core.y, std::abs(p.z) - core.z};
    const double inside = std::min(std::max({out.x, out.y, out.z}), 0.0);
    return norm({std::max(out.x, 0.0), std::max(out.y, 0.0), std::max(out.z, 0.0)}) + inside - r;
  };
  ExactShape shape = star("fillet_block", "cad", field, 1.5);
  shape.seam_distance = [=](const Vec3& p) {
    return std::min(
        {std::abs(std::abs(p.x) - core.x), std::abs(std::abs(p.y) - core.y), std::abs(std::abs(p.z) - core.z)});
  };
  return shape;
}

/// Cylinder around z with rounded rims: planes, a cylinder, parts of tori.
ExactShape fillet_cylinder(std::mt19937& generator)
{
  const double r = uniform(generator, 0.2, 0.3), radius = uniform(generator, 0.4, 0.6), half = radius;
  const auto field = [=](const Vec3& p) {
    const double rho = std::hypot(p.x, p.y) - radius, z = std::abs(p.z) - half;
    return std::hypot(std::max(rho, 0.0), std::max(z, 0.0)) + std::min(std::max(rho, z), 0.0) - r;
  };
  ExactShape shape = star("fillet_cylinder", "cad", field, 1.3);
  shape.seam_distance = [=](const Vec3& p) {
    return std::min(std::abs(std::hypot(p.x, p.y) - radius), std::abs(std::abs(p.z) - half));
  };
  return shape;
}

/// Cylinder around z closed by half spheres.
ExactShape capsule(std::mt19937& generator)
{
  const double radius = uniform(generator, 0.4, 0.6), half = uniform(generator, 0.4, 0.7);
  const auto field = [=](const Vec3& p) { return norm({p.x, p.y, std::max(std::abs(p.z) - half, 0.0)}) - radius; };
  ExactShape shape = star("capsule", "cad", field, 1.6);
  shape.seam_distance = [=](const Vec3& p) { return std::abs(std::abs(p.z) - half); };
  return shape;
}

ExactShape patch(std::string name, const std::function<double(double, double)>& height, std::mt19937& generator)
{
  const std::uint32_t seed = std::uint32_t(generator());
  const auto field = [=](const Vec3& p) { return p.z - height(p.x, p.y); };
  const auto mesh = [=](int vertices) { return patch_mesh(height, vertices, seed); };
  return {std::move(name), "open", field, {{-1, -1, -1.3}, {1, 1, 1.3}}, mesh, {}, true};
}

ExactShape saddle(std::mt19937& generator)
{
  const double a = uniform(generator, 0.3, 0.6), b = uniform(generator, 0.3, 0.6);
  return patch(
      "saddle", [=](double x, double y) { return a * x * x - b * y * y; }, generator);
}

ExactShape hill(std::mt19937& generator)
{
  const double height = uniform(generator, 0.2, 0.4), width = uniform(generator, 0.25, 0.4);
  return patch(
      "hill", [=](double x, double y) { return height * std::exp(-(x * x + y * y) / (2 * width * width)); }, generator);
}

ExactShape wavy_patch(const std::string& name, double least, double largest, std::mt19937& generator)
{
  const Waves waves(5, least, largest, generator);
  return patch(
      name,
      [=](double x, double y) {
        return 0.04 * waves({x, y, 0});
      },
      generator);
}

/// Caches the mesh for each number of vertices.
void keep_meshes(ExactShape& shape)
{
  const auto kept = std::make_shared<std::map<int, TriangleMesh>>();
  const auto make = shape.mesh;
  shape.mesh = [kept, make](int vertices) {
    const auto [it, is_new] = kept->try_emplace(vertices);
    if (is_new) it->second = make(vertices);
    return it->second;
  };
}

}  // namespace

std::vector<ExactShape> draw_shapes(Half half, std::mt19937& g)
{
  std::vector<ExactShape> shapes;
  if (half == Half::tuning) {
    shapes.push_back(ellipsoid(g));
    shapes.push_back(torus(g, false));
    shapes.push_back(bumpy_sphere(g));
    shapes.push_back(goursat(g));
    shapes.push_back(fillet_block(g));
    shapes.push_back(saddle(g));
    shapes.push_back(wavy_patch("bumps_patch", 4, 8, g));
  } else {
    shapes.push_back(sphere());
    shapes.push_back(peanut(g));
    shapes.push_back(gyroid_sphere(g));
    shapes.push_back(fillet_cylinder(g));
    shapes.push_back(capsule(g));
    shapes.push_back(torus(g, true));
    shapes.push_back(hill(g));
    shapes.push_back(wavy_patch("waves_patch", 3, 6, g));
  }
  for (ExactShape& shape : shapes) keep_meshes(shape);
  return shapes;
}

std::vector<ExactShape> textured_shapes(double edges, int vertices, std::mt19937& generator)
{
  constexpr double slope = 0.3;  // largest slope, approximately
  const double turn = uniform(generator, 0, pi);
  const double patch_edge = 2 / std::sqrt(vertices * std::sqrt(3.0) / 2);
  const double k = pi / (edges * patch_edge), height = slope / k;
  const auto bumps = [=](double x, double y) {
    const double u = k * (x * std::cos(turn) + y * std::sin(turn)), v = k * (y * std::cos(turn) - x * std::sin(turn));
    return height * std::sin(u) * std::sin(v);
  };
  std::vector<ExactShape> shapes{patch("textured_patch", bumps, generator)};

  const double tube = 0.4, torus_edge = std::sqrt(4 * pi * pi * tube / vertices * 2 / std::sqrt(3.0));
  // A whole number of bumps in both directions: their width is as asked around the tube, and on average around the
  // axis.
  const double around_tube = std::round(pi * tube / (edges * torus_edge));
  const double around_axis = std::round(pi / (edges * torus_edge));
  const double rise = slope * tube / around_tube;
  const auto field = [=](const Vec3& p) {
    const double rho = std::hypot(p.x, p.y) - 1, axis = std::atan2(p.y, p.x), angle = std::atan2(p.z, rho);
    return std::hypot(rho, p.z) - tube - rise * std::sin(around_axis * axis) * std::sin(around_tube * angle);
  };
  const auto mesh = [=](int count) {
    TriangleMesh m = torus_mesh(tube, count);
    for (Vec3& p : m.positions) p = project(field, p);
    return m;
  };
  shapes.push_back({"textured_torus", "bumpy", field, {{-1.9, -1.9, -0.9}, {1.9, 1.9, 0.9}}, mesh, {}, false});
  return shapes;
}

}  // namespace accuracy
