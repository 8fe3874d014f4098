// SPDX-License-Identifier: GPL-3.0-or-later
// The two engines against each other, and both against a cylinder by quadrature.
#include <gtest/gtest.h>

#include <cmath>

#include "integral_invariant/ball_curvature/curvature_tensor.h"
#include "integral_invariant/moments/engine.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

constexpr double pi = 3.14159265358979323846;

Parameters with_engine(EngineKind engine, double cells = 6)
{
  Parameters p = published_method();
  p.engine = engine;
  p.fft_cells_per_radius = cells;
  p.exactness = Exactness::exact;
  return p;
}

std::vector<BallMoments> moments_at(const Surface& surface, double radius, const Parameters& parameters)
{
  std::vector<BallMoments> moments(surface.vertex_count());
  Execution execution;
  make_moment_engine(surface, parameters, execution)
      ->evaluate(
          {radius}, [&](std::size_t v, int, const BallMoments& m) { moments[v] = m; }, execution);
  return moments;
}

/// RMS over the vertices of the largest eigenvalue of the difference of K·r.
double rms_difference(const std::vector<BallMoments>& a, const std::vector<BallMoments>& b, double radius)
{
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    const CurvatureTensor ta = curvature_tensor(a[v], radius), tb = curvature_tensor(b[v], radius);
    const double d = largest_absolute_curvature({ta.k - tb.k, ta.normal, 1}) * radius;
    sum += d * d;
  }
  return std::sqrt(sum / double(a.size()));
}

/// Moments of a solid cylinder of radius R (axis z) about a point of its surface at (R, 0, 0), by slices x = const < 0:
/// strips |y| < half_width of discs of radius rho.
BallMoments cylinder_moments(double R, double r)
{
  BallMoments m;
  const int slices = 2000, columns = 400;
  for (int i = 0; i < slices; ++i) {
    const double dx = r / slices, x = -(i + 0.5) * dx;
    const double rho2 = r * r - x * x, half_width = std::min(std::sqrt(-x * (2 * R + x)), std::sqrt(rho2));
    for (int j = 0; j < columns; ++j) {
      // y = half_width · sin(t): the integrand is smooth in t where the strip is the whole disc.
      const double t = -pi / 2 + pi * (j + 0.5) / columns;
      const double y = half_width * std::sin(t), dy = half_width * std::cos(t) * pi / columns;
      const double z = std::sqrt(std::max(0.0, rho2 - y * y)), w = 2 * z * dy * dx;
      m.volume += w;
      m.first.x += w * x;
      m.second += Symmetric3{x * x, 0, 0, y * y, 0, z * z / 3} * w;
    }
  }
  return m;
}

}  // namespace

TEST(Engines, ConvergeToEachOtherWithTheGridStep)
{
  const Surface smooth(torus(2, 0.7, 120, 42)), noisy(with_normal_noise(torus(2, 0.7, 120, 42), 0.02));
  const double radius = 4;
  for (const Surface* surface : {&smooth, &noisy}) {
    const auto exact = moments_at(*surface, radius, with_engine(EngineKind::surface_integral));
    const auto difference = [&](double cells) {
      return rms_difference(moments_at(*surface, radius, with_engine(EngineKind::volume_fft, cells)), exact, radius);
    };
    const double at4 = difference(4), at8 = difference(8), at16 = difference(16);
    RecordProperty(surface == &smooth ? "smooth" : "noisy",
                   std::to_string(at4) + " " + std::to_string(at8) + " " + std::to_string(at16));
    // Noise of a fifth of an edge has edges of its own: the grid's error is larger there.
    EXPECT_LT(at4, surface == &smooth ? 4e-3 : 1e-2);
    // At least second order over two halvings of the grid step.
    EXPECT_GT(at4 / at16, 16) << at4 << ' ' << at8 << ' ' << at16;
    EXPECT_LT(at16, at8);
  }
}

TEST(Engines, AgreeWithACylinder)
{
  const double R = 1, r = 0.5, step = 0.04;
  const TriangleMesh mesh = cylinder(R, 3, step);
  const Surface surface(mesh);
  const BallMoments expected = cylinder_moments(R, r);
  const double r3 = r * r * r, r5 = r3 * r * r, unit = surface.unit();
  for (const EngineKind engine : {EngineKind::volume_fft, EngineKind::surface_integral}) {
    const auto moments = moments_at(surface, r / unit, with_engine(engine, 12));
    int checked = 0;
    for (std::size_t v = 0; v < moments.size(); ++v) {
      const Vec3& p = mesh.positions[v];
      if (std::abs(p.z) > 0.9 || std::hypot(p.x, p.y) < 0.99 * R) continue;
      ++checked;
      const Vec3 radial = normalized({p.x, p.y, 0}), around{-radial.y, radial.x, 0};
      const double u3 = unit * unit * unit, u5 = u3 * unit * unit;
      // The inscribed facets lie up to step²/(8R) inside: 2e-4, which moves V by about 2e-4 · π r².
      EXPECT_NEAR(moments[v].volume * u3 / r3, expected.volume / r3, 2e-3);
      EXPECT_NEAR(dot(moments[v].first, radial) * u3 * unit / (r3 * r), expected.first.x / (r3 * r), 2e-3);
      EXPECT_NEAR(quadratic_form(moments[v].second, around) * u5 / r5, expected.second.yy / r5, 1e-3);
      EXPECT_NEAR(quadratic_form(moments[v].second, {0, 0, 1}) * u5 / r5, expected.second.zz / r5, 1e-3);
    }
    EXPECT_GT(checked, 1000);
  }
}
