// SPDX-License-Identifier: GPL-3.0-or-later
// Functions whose zeros are extrema of curvature. Cost: O(n · width²) for the second derivatives.
#include "integral_invariant/drawing/ridge_scalars.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/drawing/local_regression.h"
#include "integral_invariant/support/pi.h"

namespace integral_invariant {

namespace {

constexpr double reach_over_width = 2;

/// An apparent ridge needs some front: towards the contour secθ and with it q1 grow without bound.
constexpr double least_cosine = 0.1;

LineScalar empty_scalar(LineKind kind, std::size_t n, bool is_derivative, Execution& execution)
{
  LineScalar s;
  s.kind = kind;
  s.is_derivative = is_derivative;
  for (auto* values : {&s.value, &s.significance, &s.strength}) resize_in_steps(*values, n, execution);
  resize_in_steps(s.direction, n, execution);
  return s;
}

double ratio(double a, double b) { return b > 0 ? a / b : 0; }

/// The slope along the vertex's own direction of values that change their sign with their directions, by linear
/// regression over the width of the field's fits.
double slope_along(std::int32_t v, const Surface& surface, const DifferentiatedField& field, const LineScalar& s,
                   NeighbourhoodWalk& walk, FitVariance& variance)
{
  const Vec3& n = field.curvature.normal[v];
  const TangentFrame frame{n, s.direction[v], cross(n, s.direction[v])};
  const double width = field.width[v];
  LocalRegression<1, 1> fit;
  for (const std::int32_t q : walk.around(v, reach_over_width * width)) {
    const auto place = tangential_place(surface.positions()[v], surface.positions()[q], frame);
    const double cosine = dot(rotate_to(s.direction[q], field.curvature.normal[q], n), frame.u);
    const double trust = field.derivative_noise[q] > 0
                             ? std::min(1.0, std::pow(field.derivative_noise[v] / field.derivative_noise[q], 2))
                             : 1;
    const double weight = std::exp(-(place[0] * place[0] + place[1] * place[1]) / (2 * width * width)) * trust;
    fit.add(place, weight, {cosine < 0 ? -s.value[q] : s.value[q]});
  }
  const double slope = fit.solve()[0].slope[0];
  variance = fit.variance();
  return slope;
}

/// z of the second derivative, `error` being the standard error of the first; where it is lower than what is there
/// already. The first derivatives come from fits of the same width as this one, which are alike over more than the
/// field is.
void limit_by_second_derivative(const Surface& surface, const DifferentiatedField& field,
                                const std::vector<double>& error, LineScalar& s, Execution& execution)
{
  std::vector<NeighbourhoodWalk> walks(std::size_t(execution.threads()),
                                       NeighbourhoodWalk(surface, field.curvature.normal));
  constexpr std::size_t grain = 512;
  parallel_step(s.value.size(), grain, execution, [&](std::size_t begin, std::size_t end, int worker) {
    for (std::size_t v = begin; v < end; ++v) {
      if (!(s.significance[v] > 0)) continue;
      FitVariance variance;
      const double second = slope_along(std::int32_t(v), surface, field, s, walks[std::size_t(worker)], variance);
      const double alike = std::hypot(field.correlation[v], std::sqrt(2.0) * field.width[v]);
      s.significance[v] = std::min(s.significance[v], ratio(-second, error[v] * fit_error(1, alike, variance).slope));
    }
  });
}

/// D_t1 q1 by moving a little along t1 both ways: the tensor changes by C, and the viewer turns with the tangent plane.
double apparent_derivative(const DifferentiatedField& field, std::size_t v, const RadialCurvature& r, double x,
                           double y, double t_x, double t_y)
{
  constexpr double step = 1e-3;  // ē
  const CurvatureField& k = field.curvature;
  const CurvatureDerivative& c = field.derivative[v];
  const double turn_x = k.kappa_max[v] * t_x, turn_y = k.kappa_min[v] * t_y;
  const auto q1_at = [&](double h) {
    return apparent_curvature(k.kappa_max[v] + h * (c[0] * t_x + c[1] * t_y), h * (c[1] * t_x + c[2] * t_y),
                              k.kappa_min[v] + h * (c[2] * t_x + c[3] * t_y), x - h * r.cosine * turn_x,
                              y - h * r.cosine * turn_y, r.cosine + h * (x * turn_x + y * turn_y))
        .q1;
  };
  return (q1_at(step) - q1_at(-step)) / (2 * step);
}

}  // namespace

LineScalar ridge_scalar(const Surface& surface, const DifferentiatedField& field, LineKind kind, Execution& execution)
{
  const bool ridge = kind == LineKind::ridge;
  const CurvatureField& k = field.curvature;
  LineScalar s = empty_scalar(kind, field.size(), true, execution);
  s.direction = ridge ? k.dir_max : k.dir_min;
  for_each_index(field.size(), execution, [&](std::size_t v) {
    s.value[v] = ridge ? field.derivative[v][0] : -field.derivative[v][3];
    const double kappa = ridge ? k.kappa_max[v] : -k.kappa_min[v];
    const double rival = std::abs(ridge ? k.kappa_min[v] : k.kappa_max[v]);
    if (!(kappa > rival)) return;
    s.strength[v] = kappa;
    s.significance[v] = ratio(kappa, field.error[v]);
  });
  limit_by_second_derivative(surface, field, field.derivative_noise, s, execution);
  return s;
}

ApparentCurvature apparent_curvature(double kappa_max, double kappa_mixed, double kappa_min, double x, double y,
                                     double cosine)
{
  // Q = S + (secθ − 1) S w wᵀ = S + S v vᵀ (secθ − 1)/sin²θ, and (secθ − 1)/sin²θ = 1/(c (1 + c)).
  const double stretch = 1 / (cosine * (1 + cosine));
  const double sv_x = kappa_max * x + kappa_mixed * y, sv_y = kappa_mixed * x + kappa_min * y;
  const double q11 = kappa_max + stretch * sv_x * x, q12 = kappa_mixed + stretch * sv_x * y;
  const double q21 = kappa_mixed + stretch * sv_y * x, q22 = kappa_min + stretch * sv_y * y;
  const double a = q11 * q11 + q21 * q21, b = q11 * q12 + q21 * q22, d = q12 * q12 + q22 * q22;
  const double half = (a - d) / 2, root = std::hypot(half, b), angle = std::atan2(b, half) / 2;
  return {std::sqrt((a + d) / 2 + root), std::cos(angle), std::sin(angle)};
}

LineScalar apparent_ridge_scalar(const Surface& surface, const DifferentiatedField& field, const View& view,
                                 Execution& execution)
{
  const CurvatureField& k = field.curvature;
  LineScalar s = empty_scalar(LineKind::apparent_ridge, field.size(), true, execution);
  std::vector<double> error;
  resize_in_steps(error, field.size(), execution);
  for_each_index(field.size(), execution, [&](std::size_t v) {
    const RadialCurvature r = radial_curvature(field, v, view.toward);
    s.direction[v] = k.dir_max[v];
    if (!(r.cosine > least_cosine)) return;
    const double x = dot(view.toward, k.dir_max[v]), y = dot(view.toward, k.dir_min[v]);
    const ApparentCurvature apparent = apparent_curvature(k.kappa_max[v], 0, k.kappa_min[v], x, y, r.cosine);
    s.direction[v] = k.dir_max[v] * apparent.t1_x + k.dir_min[v] * apparent.t1_y;
    s.value[v] = apparent_derivative(field, v, r, x, y, apparent.t1_x, apparent.t1_y);
    s.strength[v] = apparent.q1;
    // What stretches the tensor stretches its error, at most by secθ.
    s.significance[v] = ratio(apparent.q1 * r.cosine, field.error[v]);
    error[v] = field.derivative_noise[v] / r.cosine;
  });
  limit_by_second_derivative(surface, field, error, s, execution);
  return s;
}

double steepest_angle(const CurvatureDerivative& c)
{
  constexpr int starts = 12, newton_steps = 4;
  const auto form = [&](double t) { return cubic_form(c, std::cos(t), std::sin(t)); };
  double best = 0;
  for (int i = 1; i < starts; ++i)
    if (form(2 * pi * i / starts) > form(best)) best = 2 * pi * i / starts;
  for (int i = 0; i < newton_steps; ++i) {
    // With t turned by a right angle: f′ = 3 C(g, g, t), f″ = 6 C(g, t, t) − 3 C(g, g, g).
    const double x = std::cos(best), y = std::sin(best);
    const double g11 = c[0] * x + c[1] * y, g12 = c[1] * x + c[2] * y, g22 = c[2] * x + c[3] * y;
    const double first = 3 * (-x * y * g11 + (x * x - y * y) * g12 + x * y * g22);
    const double second = 6 * (y * y * g11 - 2 * x * y * g12 + x * x * g22) - 3 * form(best);
    if (!(second < 0)) break;
    best -= first / second;
  }
  return best;
}

LineScalar demarcating_scalar(const DifferentiatedField& field, Execution& execution)
{
  // The mean of χ² with the four components of C: what the largest of noise reaches.
  constexpr double square_of_choice = 4;
  const CurvatureField& k = field.curvature;
  LineScalar s = empty_scalar(LineKind::demarcating_curve, field.size(), false, execution);
  for_each_index(field.size(), execution, [&](std::size_t v) {
    const double angle = steepest_angle(field.derivative[v]), x = std::cos(angle), y = std::sin(angle);
    s.direction[v] = k.dir_max[v] * x + k.dir_min[v] * y;
    s.value[v] = k.kappa_max[v] * x * x + k.kappa_min[v] * y * y;
    s.strength[v] = cubic_form(field.derivative[v], x, y);
    const double z = ratio(s.strength[v], field.derivative_noise[v]);
    s.significance[v] = std::min(std::sqrt(std::max(0.0, z * z - square_of_choice)),
                                 ratio(s.strength[v] * field.width[v], field.error[v]));
  });
  return s;
}

}  // namespace integral_invariant
