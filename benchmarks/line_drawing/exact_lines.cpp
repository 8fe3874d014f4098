// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of the shape's map by central differences of closed forms, zeros by linear interpolation on the grid.
#include "exact_lines.h"

#include <array>
#include <cmath>

#include "integral_invariant/drawing/ridge_scalars.h"

namespace line_benchmark {

using integral_invariant::cross;
using integral_invariant::dot;
using integral_invariant::norm;
using integral_invariant::normalized;

namespace {

constexpr int cells = 700;  // of the grid along each parameter

/// First and second fundamental form at a place, with the principal frame in parameters.
struct Jet {
  Vec3 position, ds, dt, normal;
  double e, f, g;  // first form
  double l, m, n;  // second form; positive where convex
};

class ExactShape {
 public:
  ExactShape(const Shape& shape, const Vec3& toward) : shape_(shape), toward_(toward)
  {
    step_s_ = (shape.s_end - shape.s_begin) * 1e-4;
    step_t_ = (shape.t_end - shape.t_begin) * 1e-4;
  }

  Jet jet(double s, double t) const
  {
    const double h = step_s_, k = step_t_;
    const auto p = [&](int i, int j) { return shape_.position(s + i * h, t + j * k); };
    Jet j;
    j.position = p(0, 0);
    j.ds = (p(1, 0) - p(-1, 0)) * (0.5 / h);
    j.dt = (p(0, 1) - p(0, -1)) * (0.5 / k);
    j.normal = normalized(cross(j.ds, j.dt));
    const Vec3 ss = (p(1, 0) + p(-1, 0) - p(0, 0) * 2) * (1 / (h * h));
    const Vec3 tt = (p(0, 1) + p(0, -1) - p(0, 0) * 2) * (1 / (k * k));
    const Vec3 st = (p(1, 1) + p(-1, -1) - p(1, -1) - p(-1, 1)) * (0.25 / (h * k));
    j.e = dot(j.ds, j.ds);
    j.f = dot(j.ds, j.dt);
    j.g = dot(j.dt, j.dt);
    j.l = -dot(ss, j.normal);
    j.m = -dot(st, j.normal);
    j.n = -dot(tt, j.normal);
    return j;
  }

  /// Parameters (a, b) with a ∂s + b ∂t the tangential part of v.
  static std::array<double, 2> in_parameters(const Jet& j, const Vec3& v)
  {
    const double x = dot(v, j.ds), y = dot(v, j.dt), determinant = j.e * j.g - j.f * j.f;
    return {(j.g * x - j.f * y) / determinant, (j.e * y - j.f * x) / determinant};
  }

  double radial_curvature(double s, double t) const
  {
    const Jet j = jet(s, t);
    const auto [a, b] = in_parameters(j, toward_);
    const double squared = j.e * a * a + 2 * j.f * a * b + j.g * b * b;
    return (j.l * a * a + 2 * j.m * a * b + j.n * b * b) / squared;
  }

  /// Of κ_r along w; of a principal curvature along its direction.
  template <class Function>
  double derivative(const Function& f, double s, double t, const std::array<double, 2>& way) const
  {
    return (f(s + step_s_ * 10, t) - f(s - step_s_ * 10, t)) / (20 * step_s_) * way[0] +
           (f(s, t + step_t_ * 10) - f(s, t - step_t_ * 10)) / (20 * step_t_) * way[1];
  }

  struct Value {
    double zero, keep;
  };

  Value value(LineKind kind, double s, double t) const
  {
    const Jet j = jet(s, t);
    const double cosine = dot(j.normal, toward_);
    if (kind == LineKind::contour) return {cosine, 1};
    const auto [a, b] = in_parameters(j, toward_);
    const double length = std::sqrt(j.e * a * a + 2 * j.f * a * b + j.g * b * b);
    const auto kappa_r = [&](double p, double q) { return radial_curvature(p, q); };
    const double sign = kind == LineKind::suggestive_contour ? 1 : -1;
    const double rise = derivative(kappa_r, s, t, {a / length, b / length});
    return {j.l * a * a + 2 * j.m * a * b + j.n * b * b, cosine > 0 ? sign * rise : -1};
  }

 private:
  const Shape& shape_;
  Vec3 toward_;
  double step_s_, step_t_;
};

}  // namespace

std::vector<ExactSegment> exact_lines(const Shape& shape, LineKind kind, const Vec3& toward)
{
  const ExactShape exact(shape, toward);
  const auto s_at = [&](double i) { return shape.s_begin + (shape.s_end - shape.s_begin) * i / cells; };
  const auto t_at = [&](double i) { return shape.t_begin + (shape.t_end - shape.t_begin) * i / cells; };
  std::vector<ExactShape::Value> grid(std::size_t(cells + 1) * (cells + 1));
  // Half a cell off the axes of symmetry, where a function may be zero along a row.
  constexpr double off = 0.37;
  for (int i = 0; i <= cells; ++i)
    for (int k = 0; k <= cells; ++k)
      grid[std::size_t(i * (cells + 1) + k)] = exact.value(kind, s_at(i + off), t_at(k + off));
  std::vector<ExactSegment> lines;
  const auto add_in = [&](std::array<std::array<int, 2>, 3> corner) {
    std::array<Vec3, 2> ends;
    int found = 0;
    double keep = 0;
    for (int i = 0; i < 3; ++i) {
      const auto &p = corner[i], &q = corner[(i + 1) % 3];
      const auto &a = grid[std::size_t(p[0] * (cells + 1) + p[1])], &b = grid[std::size_t(q[0] * (cells + 1) + q[1])];
      keep += a.keep;
      if ((a.zero >= 0) == (b.zero >= 0) || found == 2) continue;
      const double u = a.zero / (a.zero - b.zero);
      ends[std::size_t(found++)] =
          shape.position(s_at(p[0] + off + (q[0] - p[0]) * u), t_at(p[1] + off + (q[1] - p[1]) * u));
    }
    if (found == 2 && keep > 0) lines.push_back({ends[0], ends[1]});
  };
  for (int i = 0; i < cells; ++i)
    for (int k = 0; k < cells; ++k) {
      add_in({{{i, k}, {i + 1, k}, {i + 1, k + 1}}});
      add_in({{{i, k}, {i + 1, k + 1}, {i, k + 1}}});
    }
  return lines;
}

}  // namespace line_benchmark
