// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/feature_shapes.h"

#include <cmath>

#include "integral_invariant/ball_curvature/curvature_tensor.h"

namespace test_support {

using namespace integral_invariant;

namespace {

Result empty_result(const TriangleMesh& mesh)
{
  Result result;
  const std::size_t n = mesh.positions.size();
  for (auto* values : {&result.kappa_max, &result.kappa_min, &result.radius}) values->assign(n, 0);
  for (auto* vectors : {&result.dir_max, &result.dir_min, &result.normal}) vectors->resize(n);
  result.confidence.assign(n, 1);
  result.average_edge = average_edge_length(mesh);
  return result;
}

/// Root of f in (low, high), where f falls or rises through 0 once.
template <class F>
double bisect(double low, double high, const F& f)
{
  const bool rising = f(low) < f(high);
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    ((f(middle) < 0) == rising ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

TriangleMesh ellipsoid(int levels, Vec3 axes)
{
  TriangleMesh mesh = icosphere(levels);
  for (Vec3& p : mesh.positions) p = {p.x * axes.x, p.y * axes.y, p.z * axes.z};
  return mesh;
}

Result ellipsoid_curvature(const TriangleMesh& mesh, Vec3 axes)
{
  Result result = empty_result(mesh);
  const Symmetric3 hessian{2 / (axes.x * axes.x), 0, 0, 2 / (axes.y * axes.y), 0, 2 / (axes.z * axes.z)};
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3 gradient = hessian * mesh.positions[v], normal = normalized(gradient);
    const PrincipalCurvatures k = principal_curvatures({hessian * (1 / norm(gradient)), normal, 1});
    result.kappa_max[v] = k.kappa_max;
    result.kappa_min[v] = k.kappa_min;
    result.dir_max[v] = k.dir_max;
    result.dir_min[v] = k.dir_min;
    result.normal[v] = normal;
  }
  return result;
}

Result torus_curvature(const TriangleMesh& mesh, double major_radius, double tube_radius)
{
  Result result = empty_result(mesh);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    const Vec3 out = normalized({p.x, p.y, 0});
    result.normal[v] = normalized(p - out * major_radius);
    result.kappa_max[v] = 1 / tube_radius;
    result.kappa_min[v] = dot(result.normal[v], out) / norm({p.x, p.y, 0});
    result.dir_min[v] = cross({0, 0, 1}, out);
    result.dir_max[v] = cross(result.normal[v], result.dir_min[v]);
  }
  return result;
}

std::vector<Vec3> ellipsoid_umbilics(Vec3 axes)
{
  const double a2 = axes.x * axes.x, b2 = axes.y * axes.y, c2 = axes.z * axes.z;
  const double x = axes.x * std::sqrt((a2 - b2) / (a2 - c2)), z = axes.z * std::sqrt((b2 - c2) / (a2 - c2));
  return {{x, 0, z}, {x, 0, -z}, {-x, 0, z}, {-x, 0, -z}};
}

Confocal confocal_coordinates(Vec3 p, Vec3 axes)
{
  const double a2 = axes.x * axes.x, b2 = axes.y * axes.y, c2 = axes.z * axes.z;
  p *= 1 / std::sqrt(p.x * p.x / a2 + p.y * p.y / b2 + p.z * p.z / c2);
  // Without the denominators: (a² − λ)(b² − λ)(c² − λ) (Σ p_i²/(a_i² − λ) − 1) / λ is a parabola with the roots μ and
  // ν.
  const auto f = [&](double s) {
    return (p.x * p.x * (b2 - s) * (c2 - s) + p.y * p.y * (a2 - s) * (c2 - s) + p.z * p.z * (a2 - s) * (b2 - s) -
            (a2 - s) * (b2 - s) * (c2 - s)) /
           s;
  };
  return {bisect(c2, b2, f), bisect(b2, a2, f)};
}

TriangleMesh box_with_ridge(double length, double height, double step, double x0, double ridge_height, double width)
{
  TriangleMesh mesh = box(length, length, height, step);
  for (Vec3& p : mesh.positions)
    if (p.z > height - step / 2) p.z += ridge_height * std::exp(-(p.x - x0) * (p.x - x0) / (2 * width * width));
  return mesh;
}

}  // namespace test_support
