// SPDX-License-Identifier: GPL-3.0-or-later
// Functions whose zeros are contours, suggestive contours and sections. Cost: O(n).
#include "integral_invariant/drawing/line_scalars.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

namespace {

LineScalar empty_scalar(LineKind kind, std::size_t n, Execution& execution)
{
  LineScalar s;
  s.kind = kind;
  for (auto* values : {&s.value, &s.significance, &s.strength}) resize_in_steps(*values, n, execution);
  return s;
}

constexpr double reach_on_both_sides = 4;  // widths: that of the local fits is 2 of them
constexpr double certain_error = 2;  // standard errors, from which on a curvature has a sign

double ratio(double a, double b) { return b > 0 ? a / b : 0; }

}  // namespace

RadialCurvature radial_curvature(const DifferentiatedField& field, std::size_t v, const Vec3& toward)
{
  const CurvatureField& k = field.curvature;
  const double x = dot(toward, k.dir_max[v]), y = dot(toward, k.dir_min[v]);
  RadialCurvature r;
  r.cosine = dot(toward, k.normal[v]);
  r.squared_sine = x * x + y * y;
  r.scaled = k.kappa_max[v] * x * x + k.kappa_min[v] * y * y;
  if (!(r.squared_sine > 0)) return r;
  // Along w = (x, y)/sinθ, which itself turns as the vertex moves: that is what the torsion τ stands for.
  const double torsion = (k.kappa_min[v] - k.kappa_max[v]) * x * y / r.squared_sine;
  r.derivative = cubic_form(field.derivative[v], x, y) / r.squared_sine - 2 * r.cosine * torsion * torsion;
  r.derivative_error =
      std::hypot(std::sqrt(r.squared_sine) * field.derivative_noise[v], 4 * r.cosine * torsion * field.error[v]);
  return r;
}

LineScalar contour_scalar(const DifferentiatedField& field, const View& view, Execution& execution)
{
  LineScalar s = empty_scalar(LineKind::contour, field.size(), execution);
  for_each_index(field.size(), execution, [&](std::size_t v) {
    const RadialCurvature r = radial_curvature(field, v, view.toward);
    s.value[v] = r.cosine;
    const double radial = ratio(r.scaled, r.squared_sine);
    s.strength[v] = radial < -certain_error * field.error[v] ? radial : std::max(radial, 0.0);
    s.significance[v] = largest_significance;
  });
  return s;
}

LineScalar suggestive_scalar(const DifferentiatedField& field, const View& view, LineKind kind, Execution& execution)
{
  LineScalar s = empty_scalar(kind, field.size(), execution);
  const double sign = kind == LineKind::suggestive_contour ? 1 : -1;
  for_each_index(field.size(), execution, [&](std::size_t v) {
    const RadialCurvature r = radial_curvature(field, v, view.toward);
    s.value[v] = r.scaled;
    if (!(r.cosine > 0)) return;
    s.strength[v] = sign * ratio(r.derivative, std::sqrt(r.squared_sine));
    const double z = sign * ratio(r.derivative, r.derivative_error);
    const double change = reach_on_both_sides * std::abs(s.strength[v]) * field.width[v];
    s.significance[v] = std::min(z, ratio(change, field.error[v]));
  });
  return s;
}

LineScalar section_scalar(const DifferentiatedField& field, const Vec3& normal, double offset, Execution& execution)
{
  LineScalar s = empty_scalar(LineKind::section, field.size(), execution);
  for_each_index(field.size(), execution, [&](std::size_t v) {
    s.value[v] = dot(field.position[v], normal) - offset;
    s.significance[v] = largest_significance;
  });
  return s;
}

}  // namespace integral_invariant
