// SPDX-License-Identifier: GPL-3.0-or-later
// Derivative of the curvature tensor by linear regression of tensors in one tangent plane. In: field. Out: C and its
// standard error. Source: the coefficients of Rusinkiewicz 2004, from a field instead of one ring of triangles.
#include "integral_invariant/drawing/field_derivative.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/ball_curvature/curvature_tensor.h"
#include "integral_invariant/drawing/local_regression.h"
#include "integral_invariant/features/topology.h"
#include "integral_invariant/support/pi.h"

namespace integral_invariant {

namespace {

/// Over which part of a ball's radius the errors of its curvature are alike: the kernel that measures curvature has its
/// mass near the rim and at the centre, so that it changes sign within a shift of about a third of the radius.
constexpr double correlation_over_radius = 0.35;
constexpr double width_over_radius = 0.5;
constexpr double least_width = 1, largest_width = 6;  // ē
constexpr double reach_over_width = 2;                // the weight there is 0.14
/// What a misfit costs. It is the surface's cubic part mostly: of c x³ a quadratic fit with Gaussian weights of the
/// width R leaves the root mean square √6 c R³, and its slope is 3 c R² too large. Its value is moved by the quartic
/// part only: measured on tori and ellipsoids without noise.
constexpr double value_of_misfit = 0.1, slope_of_misfit = 1.22;
/// The field's error is known to about this factor of its variance: only what a fit leaves over beyond is a misfit.
constexpr double certain_misfit = 2;
constexpr double rounding = 1e-6;  // ē: coordinates in single precision on a mesh of a few hundred edges

class Differentiator {
 public:
  Differentiator(const Surface& surface, const MeasuredField& field, const std::vector<double>& areas,
                 DifferentiatedField& out)
      : surface_(surface), in_(field), areas_(areas), out_(out)
  {
  }

  void at(std::int32_t v, NeighbourhoodWalk& walk) const
  {
    const TangentFrame frame = frame_of(v);
    const double width = std::clamp(width_over_radius * in_.radius[v], least_width, largest_width);
    const auto& around = walk.around(v, reach_over_width * width);
    const double typical = typical_variance(v, around, frame, width);
    LocalRegression<2, 3> tensors;
    double variance = 0, squares = 0, weights = 0;
    for (const std::int32_t q : around) {
      const auto place = tangential_place(surface_.positions()[v], surface_.positions()[q], frame);
      const double weight = weight_at(q, place, width) * trust_in(q, typical);
      tensors.add(place, weight, components(q, frame));
      variance += weight * in_.error[q] * in_.error[q];
      weights += weight;
    }
    const Fits fits = tensors.solve();
    for (const std::int32_t q : around) {
      const auto place = tangential_place(surface_.positions()[v], surface_.positions()[q], frame);
      squares +=
          weight_at(q, place, width) * trust_in(q, typical) * squared_residual(fits, place, components(q, frame));
    }
    out_.width[v] = width;
    take_errors(v, tensors.variance(), variance / weights, squares / weights);
    take_tensor(v, frame, fits);
    out_.position[v] = fitted_position(v, frame, fits, around, width);
  }

 private:
  using Components = std::array<double, 3>;  ///< K_uu, K_uv, K_vv
  using Fits = std::array<LocalFit, 3>;      ///< of these

  TangentFrame frame_of(std::int32_t v) const
  {
    const Vec3& n = in_.curvature.normal[v];
    return {n, in_.curvature.dir_max[v], cross(n, in_.curvature.dir_max[v])};
  }

  /// The tensor at q in the frame, turned from q's tangent plane the shortest way.
  Components components(std::int32_t q, const TangentFrame& frame) const
  {
    const CurvatureField& f = in_.curvature;
    const Vec3 e = rotate_to(f.dir_max[q], f.normal[q], frame.normal);
    const double x = dot(e, frame.u), y = dot(e, frame.v), k1 = f.kappa_max[q], k2 = f.kappa_min[q];
    return {k1 * x * x + k2 * y * y, (k1 - k2) * x * y, k1 * y * y + k2 * x * x};
  }

  double weight_at(std::int32_t q, const std::array<double, 2>& place, double width) const
  {
    return areas_[q] * std::exp(-(place[0] * place[0] + place[1] * place[1]) / (2 * width * width));
  }

  /// The weighted harmonic mean of the field's variances: that of its better vertices.
  double typical_variance(std::int32_t v, const std::vector<std::int32_t>& around, const TangentFrame& frame,
                          double width) const
  {
    double weights = 0, inverse = 0;
    for (const std::int32_t q : around) {
      if (!(in_.error[q] > 0)) return 0;
      const double weight =
          weight_at(q, tangential_place(surface_.positions()[v], surface_.positions()[q], frame), width);
      weights += weight;
      inverse += weight / (in_.error[q] * in_.error[q]);
    }
    return weights / inverse;
  }

  /// At most 2, so that no fit hangs on a few vertices with small errors; small for outliers, which know that they are.
  double trust_in(std::int32_t q, double typical) const
  {
    return typical > 0 ? 2 * typical / (typical + in_.error[q] * in_.error[q]) : 1;
  }

  static double squared_residual(const Fits& fits, const std::array<double, 2>& place, const Components& k)
  {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double r = k[i] - fits[i](place);
      sum += (i == 1 ? 2 : 1) * r * r;  // K_uv stands in the tensor twice
    }
    return sum / 2;  // of either curvature
  }

  /// `variance`: of the field around; `residual`: the mean square of what the fit leaves over.
  void take_errors(std::int32_t v, const FitVariance& fit_variance, double variance, double residual) const
  {
    // Independent values, one a vertex, are alike over the circle that holds one: 2π ℓ² is its area.
    const double least_correlation = std::sqrt(areas_[v] / (2 * pi));
    const double correlation = std::max(correlation_over_radius * in_.radius[v], least_correlation);
    const double radius = std::max(in_.radius[v], 1.0);
    const double misfit = variance > 0 ? std::sqrt(std::max(residual - certain_misfit * variance, 0.0)) : 0;
    // More than the field knows of: noise of a kind that its estimate does not see, such as noise over many vertices.
    const double sigma = std::hypot(std::sqrt(std::max(variance, residual)), rounding / (radius * radius));
    const FitError error = fit_error(2, correlation, fit_variance);
    out_.correlation[v] = correlation;
    out_.error[v] = std::hypot(sigma * error.value, value_of_misfit * misfit);
    out_.derivative_noise[v] = sigma * error.slope;
    out_.derivative_error[v] = std::hypot(out_.derivative_noise[v], slope_of_misfit * misfit / out_.width[v]);
  }

  void take_tensor(std::int32_t v, const TangentFrame& frame, const Fits& fits) const
  {
    const Symmetric3 k = outer(frame.u) * fits[0].value + symmetric_outer(frame.u, frame.v) * fits[1].value +
                         outer(frame.v) * fits[2].value;
    const PrincipalCurvatures p = principal_curvatures({k, frame.normal, 1});
    CurvatureField& field = out_.curvature;
    field.kappa_max[v] = p.kappa_max;
    field.kappa_min[v] = p.kappa_min;
    field.dir_max[v] = p.dir_max;
    field.dir_min[v] = cross(frame.normal, p.dir_max);
    field.normal[v] = frame.normal;
    // C is symmetric in all indices: each mixed component is seen twice, K_uv being two entries of the tensor.
    const CurvatureDerivative c{fits[0].slope[0], (fits[0].slope[1] + 2 * fits[1].slope[0]) / 3,
                                (fits[2].slope[0] + 2 * fits[1].slope[1]) / 3, fits[2].slope[1]};
    const double x = dot(p.dir_max, frame.u), y = dot(p.dir_max, frame.v);
    out_.derivative[v] = turned_into(c, x, y);
  }

  /// The same cubic form in the frame whose first direction is (x, y).
  static CurvatureDerivative turned_into(const CurvatureDerivative& c, double x, double y)
  {
    // Contractions with e1 = (x, y) and e2 = (−y, x), one index after the other.
    const std::array<double, 3> along{c[0] * x + c[1] * y, c[1] * x + c[2] * y, c[2] * x + c[3] * y};
    const std::array<double, 3> beside{-c[0] * y + c[1] * x, -c[1] * y + c[2] * x, -c[2] * y + c[3] * x};
    const auto form = [](const std::array<double, 3>& k, double a, double b, double p, double q) {
      return k[0] * a * p + k[1] * (a * q + b * p) + k[2] * b * q;
    };
    return {form(along, x, y, x, y), form(along, x, y, -y, x), form(along, -y, x, -y, x), form(beside, -y, x, -y, x)};
  }

  /// The heights around v less z = −K(x, x)/2 − C(x, x, x)/6, as a linear function, at v.
  Vec3 fitted_position(std::int32_t v, const TangentFrame& frame, const Fits& fits,
                       const std::vector<std::int32_t>& around, double width) const
  {
    const CurvatureField& field = out_.curvature;
    const std::vector<Vec3>& p = surface_.positions();
    const double turn_x = dot(field.dir_max[v], frame.u), turn_y = dot(field.dir_max[v], frame.v);
    LocalRegression<1, 1> heights;
    for (const std::int32_t q : around) {
      const Vec3 way = p[q] - p[v];
      const double x = dot(way, frame.u), y = dot(way, frame.v);
      const double bend = fits[0].value * x * x + 2 * fits[1].value * x * y + fits[2].value * y * y;
      const double cubic = cubic_form(out_.derivative[v], x * turn_x + y * turn_y, y * turn_x - x * turn_y);
      heights.add({x, y}, areas_[q] * std::exp(-(x * x + y * y) / (2 * width * width)),
                  {dot(way, frame.normal) + bend / 2 + cubic / 6});
    }
    return p[v] + frame.normal * heights.solve()[0].value;
  }

  const Surface& surface_;
  const MeasuredField& in_;
  const std::vector<double>& areas_;
  DifferentiatedField& out_;
};

void resize(DifferentiatedField& field, const MeasuredField& like, Execution& execution)
{
  const std::size_t n = like.curvature.size();
  field.curvature = like.curvature;
  execution.check();
  for (auto* values :
       {&field.error, &field.derivative_error, &field.derivative_noise, &field.correlation, &field.width})
    resize_in_steps(*values, n, execution);
  resize_in_steps(field.derivative, n, execution);
  resize_in_steps(field.position, n, execution);
}

}  // namespace

MeasuredField measured_field(const Result& result)
{
  MeasuredField field{curvature_field(result), result.standard_error, result.radius};
  for (double& e : field.error) e *= result.average_edge;
  for (double& r : field.radius) r /= result.average_edge;
  return field;
}

DifferentiatedField differentiate(const Surface& surface, const MeasuredField& field, Execution& execution)
{
  DifferentiatedField out;
  resize(out, field, execution);
  const std::vector<double> areas = vertex_areas(surface, execution);
  const Differentiator differentiator(surface, field, areas, out);
  std::vector<NeighbourhoodWalk> walks(std::size_t(execution.threads()),
                                       NeighbourhoodWalk(surface, field.curvature.normal));
  parallel_for(surface.vertex_count(), 512, execution, [&](std::size_t begin, std::size_t end, int worker) {
    for (std::size_t v = begin; v < end; ++v) {
      out.position[v] = surface.positions()[v];
      if (surface.is_referenced(v)) differentiator.at(std::int32_t(v), walks[std::size_t(worker)]);
    }
  });
  return out;
}

}  // namespace integral_invariant
