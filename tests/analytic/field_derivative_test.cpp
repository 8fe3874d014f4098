// SPDX-License-Identifier: GPL-3.0-or-later
// The derivative of the curvature tensor where it has a closed form: Monge patch, torus, ellipsoid; and whether its
// standard error covers what noise does to it.
#include "integral_invariant/drawing/field_derivative.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "integral_invariant/ball_curvature/curvature_tensor.h"
#include "integral_invariant/curvature.h"
#include "support/feature_shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

/// C(t, t, t) at a vertex of the shape for a unit tangent vector, in the unit of the mesh.
using ExactForm = std::function<double(const Vec3& position, const Vec3& t)>;

/// C₁₂₂ alone, where 1 is the meridian: −R sinφ / (r (R + r cosφ)²), and its direction that of growing φ.
ExactForm torus_form(double major_radius, double tube_radius)
{
  return [=](const Vec3& p, const Vec3& t) {
    const double rho = std::hypot(p.x, p.y), phi = std::atan2(p.z, rho - major_radius);
    const Vec3 around{-p.y / rho, p.x / rho, 0};
    const Vec3 meridian{-std::sin(phi) * p.x / rho, -std::sin(phi) * p.y / rho, std::cos(phi)};
    const double along = dot(t, meridian), across = dot(t, around);
    return -3 * along * across * across * major_radius * std::sin(phi) / (tube_radius * rho * rho);
  };
}

/// On F(x) = Σ x²/a² = 1 with its Hessian H and n = ∇F/|∇F|: C(t, t, t) = −3 II(t, t) nᵀHt / |∇F|, II(t, t) = tᵀHt /
/// |∇F|.
ExactForm ellipsoid_form(const Vec3& axes)
{
  return [=](const Vec3& p, const Vec3& t) {
    const auto times_hessian = [&](const Vec3& v) {
      return Vec3{2 * v.x / (axes.x * axes.x), 2 * v.y / (axes.y * axes.y), 2 * v.z / (axes.z * axes.z)};
    };
    const Vec3 gradient = times_hessian(p);
    const double size = norm(gradient);
    return -3 * dot(t, times_hessian(t)) / size * dot(gradient, times_hessian(t)) / (size * size);
  };
}

DifferentiatedField differentiated(const TriangleMesh& mesh, MeasuredField field)
{
  Execution execution;
  return differentiate(Surface(mesh), field, execution);
}

DifferentiatedField of_exact_field(const TriangleMesh& mesh, const Result& result)
{
  MeasuredField field{curvature_field(result), std::vector<double>(mesh.positions.size(), 0),
                      std::vector<double>(mesh.positions.size(), 4)};
  return differentiated(mesh, std::move(field));
}

/// Root mean squares over all vertices and four directions, 45 degrees apart, of each.
struct Errors {
  double form = 0;    ///< of the exact C(t, t, t)
  double error = 0;   ///< of what is wrong
  double z = 0;       ///< of the error over its standard error
  double within = 0;  ///< share of the errors below their standard errors
};

/// `edge`: that of the mesh which `d` belongs to, of which `clean` has the vertices without noise.
Errors errors_of(const DifferentiatedField& d, const TriangleMesh& clean, double edge, const ExactForm& exact)
{
  Errors sum;
  constexpr int directions = 4;
  for (std::size_t v = 0; v < d.size(); ++v)
    for (int i = 0; i < directions; ++i) {
      const double angle = 3.14159265358979 * i / directions, x = std::cos(angle), y = std::sin(angle);
      const Vec3 t = d.curvature.dir_max[v] * x + d.curvature.dir_min[v] * y;
      const double truth = exact(clean.positions[v], t) * edge * edge;
      const double error = cubic_form(d.derivative[v], x, y) - truth, z = error / d.derivative_error[v];
      sum.form += truth * truth;
      sum.error += error * error;
      sum.z += z * z;
      sum.within += std::abs(z) < 1;
    }
  const double count = double(d.size()) * directions;
  return {std::sqrt(sum.form / count), std::sqrt(sum.error / count), std::sqrt(sum.z / count), sum.within / count};
}

/// z = −(k₁x² + k₂y²)/2 − (a x³ + 3b x²y + 3c xy² + d y³)/6 on a triangulated square of side 2, 41 × 41 vertices.
struct MongePatch {
  double k1, k2;
  CurvatureDerivative c;

  Vec3 gradient(double x, double y) const
  {
    return {k1 * x + (c[0] * x * x + 2 * c[1] * x * y + c[2] * y * y) / 2,
            k2 * y + (c[1] * x * x + 2 * c[2] * x * y + c[3] * y * y) / 2, 1};
  }
  Symmetric3 hessian(double x, double y) const
  {
    return {k1 + c[0] * x + c[1] * y, c[1] * x + c[2] * y, 0, k2 + c[2] * x + c[3] * y, 0, 0};
  }
  double height(double x, double y) const { return -(k1 * x * x + k2 * y * y) / 2 - cubic_form(c, x, y) / 6; }
};

TriangleMesh mesh_of(const MongePatch& patch)
{
  constexpr int half = 20;
  TriangleMesh mesh;
  for (int j = -half; j <= half; ++j)
    for (int i = -half; i <= half; ++i) {
      const double x = double(i) / half, y = double(j) / half;
      mesh.positions.push_back({x, y, patch.height(x, y)});
    }
  constexpr int row = 2 * half + 1;
  for (int j = 0; j + 1 < row; ++j)
    for (int i = 0; i + 1 < row; ++i) {
      const int a = j * row + i;
      mesh.triangles.push_back({a, a + 1, a + row + 1});
      mesh.triangles.push_back({a, a + row + 1, a + row});
    }
  return mesh;
}

Result exact_result(const MongePatch& patch, const TriangleMesh& mesh)
{
  Result result;
  result.average_edge = average_edge_length(mesh);
  for (const Vec3& p : mesh.positions) {
    const Vec3 gradient = patch.gradient(p.x, p.y);
    const PrincipalCurvatures k =
        principal_curvatures({patch.hessian(p.x, p.y) * (1 / norm(gradient)), normalized(gradient), 1});
    result.kappa_max.push_back(k.kappa_max);
    result.kappa_min.push_back(k.kappa_min);
    result.dir_max.push_back(k.dir_max);
    result.dir_min.push_back(k.dir_min);
    result.normal.push_back(normalized(gradient));
  }
  return result;
}

Errors errors_without_noise(const TriangleMesh& mesh, const Result& result, const ExactForm& exact)
{
  return errors_of(of_exact_field(mesh, result), mesh, average_edge_length(mesh), exact);
}

Errors errors_under_noise(const TriangleMesh& clean, const ExactForm& exact, double sigma)
{
  const TriangleMesh mesh = with_normal_noise(clean, sigma * average_edge_length(clean));
  return errors_of(differentiated(mesh, measured_field(compute_curvature(mesh, {}))), clean, average_edge_length(mesh),
                   exact);
}

}  // namespace

TEST(FieldDerivative, OfAMongePatchIsItsThirdDerivatives)
{
  const MongePatch patch{0.5, -0.2, {0.6, -0.4, 0.3, 0.8}};
  const TriangleMesh mesh = mesh_of(patch);
  const DifferentiatedField d = of_exact_field(mesh, exact_result(patch, mesh));
  const std::size_t middle = mesh.positions.size() / 2;
  const double edge = average_edge_length(mesh);
  const double sign = d.curvature.dir_max[middle].x > 0 ? 1 : -1;
  // Both directions turn together: the frame is right-handed.
  EXPECT_NEAR(d.curvature.dir_min[middle].y, sign, 0.02);
  EXPECT_NEAR(d.curvature.kappa_max[middle] / edge, patch.k1, 0.005);
  EXPECT_NEAR(d.curvature.kappa_min[middle] / edge, patch.k2, 0.005);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(sign * d.derivative[middle][i] / (edge * edge), patch.c[i], 0.03) << i;
}

TEST(FieldDerivative, OfExactFieldsIsTheirClosedForm)
{
  const TriangleMesh ring = torus(3, 1, 280, 80);
  const Errors on_ring = errors_without_noise(ring, torus_curvature(ring, 3, 1), torus_form(3, 1));
  EXPECT_LT(on_ring.error, 0.01 * on_ring.form);
  const Vec3 axes{2, 1.4, 0.8};
  const TriangleMesh egg = ellipsoid(6, axes);
  const Errors on_egg = errors_without_noise(egg, ellipsoid_curvature(egg, axes), ellipsoid_form(axes));
  EXPECT_LT(on_egg.error, 0.04 * on_egg.form);
}

TEST(FieldDerivative, ErrorFallsWithTheSquareOfTheEdge)
{
  const Vec3 axes{2, 1.4, 0.8};
  std::vector<double> relative;
  for (const int levels : {5, 6}) {
    const TriangleMesh egg = ellipsoid(levels, axes);
    const Errors e = errors_without_noise(egg, ellipsoid_curvature(egg, axes), ellipsoid_form(axes));
    relative.push_back(e.error / e.form);
  }
  EXPECT_NEAR(std::log2(relative[0] / relative[1]), 2, 0.4);
}

// With less noise than 0.1 edges the bias of wide neighbourhoods is larger than the error that noise makes.
TEST(FieldDerivative, StandardErrorCoversTheErrorUnderNoise)
{
  const Vec3 axes{1.5, 1.2, 1};  // bends within 26 edges at the sharpest
  struct Case {
    const char* name;
    TriangleMesh clean;
    ExactForm exact;
  };
  const Case cases[] = {{"torus", torus(3, 1, 280, 80), torus_form(3, 1)},
                        {"ellipsoid", ellipsoid(6, axes), ellipsoid_form(axes)},
                        {"sphere", icosphere(5), [](const Vec3&, const Vec3&) { return 0.0; }}};
  for (const Case& c : cases)
    for (const double sigma : {0.1, 0.5}) {
      const Errors e = errors_under_noise(c.clean, c.exact, sigma);
      EXPECT_GT(e.within, 0.6) << c.name << ' ' << sigma;
      EXPECT_LT(e.z, 1.5) << c.name << ' ' << sigma;
      EXPECT_GT(e.z, 0.3) << c.name << ' ' << sigma;
    }
}

TEST(FieldDerivative, PutsVerticesBackOnTheSurfaceUnderNoise)
{
  const TriangleMesh clean = torus(3, 1, 280, 80);
  const double edge = average_edge_length(clean), sigma = 0.2;
  const TriangleMesh mesh = with_normal_noise(clean, sigma * edge);
  const Surface surface(mesh);
  Execution execution;
  const DifferentiatedField d = differentiate(surface, measured_field(compute_curvature(mesh, {})), execution);
  const Vec3 shift = mesh.positions[0] - surface.positions()[0] * surface.unit();
  double squares = 0;
  for (const Vec3& p : d.position) {
    const Vec3 q = p * surface.unit() + shift;
    squares += std::pow(std::hypot(std::hypot(q.x, q.y) - 3, q.z) - 1, 2);
  }
  EXPECT_LT(std::sqrt(squares / double(d.size())), 0.6 * sigma * edge);
}
