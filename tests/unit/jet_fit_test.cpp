// SPDX-License-Identifier: GPL-3.0-or-later
// Fits of polynomials to vertices, on graphs that are such polynomials and on noise of known strength.
#include "integral_invariant/jets/jet_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

using namespace integral_invariant;

namespace {

/// Graph over a square of (2 side + 1)² vertices, a third of a unit apart and jittered; the solid is below.
TriangleMesh graph(int side, const std::function<double(double, double)>& height, double noise = 0)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> jitter(-0.1, 0.1);
  std::normal_distribution<double> gauss(0, 1);
  TriangleMesh mesh;
  const int row = 2 * side + 1;
  for (int j = -side; j <= side; ++j)
    for (int i = -side; i <= side; ++i) {
      const bool is_centre = i == 0 && j == 0;
      const double x = (i + (is_centre ? 0 : jitter(generator))) / 3, y = (j + (is_centre ? 0 : jitter(generator))) / 3;
      mesh.positions.push_back({x, y, height(x, y) + noise * gauss(generator)});
    }
  for (int j = 0; j + 1 < row; ++j)
    for (int i = 0; i + 1 < row; ++i) {
      const int a = j * row + i;
      mesh.triangles.push_back({a, a + 1, a + row + 1});
      mesh.triangles.push_back({a, a + row + 1, a + row});
    }
  return mesh;
}

std::size_t centre_of(const Surface& surface) { return (surface.vertex_count() - 1) / 2; }

std::vector<Jet> discs(JetFitter& fitter, std::size_t v, const std::vector<double>& radii)
{
  std::vector<Jet> fits;
  fitter.begin_disc(v, {0, 0, 1});
  for (const double r : radii) fits.push_back(fitter.extend_disc(r));
  return fits;
}

}  // namespace

TEST(Jet, PolynomialOfDegreeFourIsExact)
{
  const auto height = [](double x, double y) {
    return 0.1 * x - 0.2 * y - 0.3 * x * x + 0.1 * x * y + 0.05 * y * y + 0.2 * x * x * y - 0.1 * x * y * y * y;
  };
  const Surface surface(graph(6, height));
  const Jet fit = JetFitter(surface).nearest(centre_of(surface), {0, 0, 1});
  // Of the graph at the origin: slopes p, q and second derivatives a, b, c.
  const double p = 0.1, q = -0.2, a = -0.6, b = 0.1, c = 0.1, stretch2 = 1 + p * p + q * q;
  const double mean = -((1 + q * q) * a - 2 * p * q * b + (1 + p * p) * c) / (2 * std::pow(stretch2, 1.5));
  const double gauss = (a * c - b * b) / (stretch2 * stretch2);
  const PrincipalCurvatures k = principal_curvatures(fit.tensor);
  EXPECT_NEAR((k.kappa_max + k.kappa_min) / (2 * surface.unit()), mean, 1e-9);
  EXPECT_NEAR(k.kappa_max * k.kappa_min / (surface.unit() * surface.unit()), gauss, 1e-9);
  EXPECT_NEAR(norm(cross(fit.tensor.normal, normalized({-p, -q, 1}))), 0, 1e-9);
  EXPECT_NEAR(fit.residual_variance, 0, 1e-18);
}

TEST(Jet, AnyRoughNormalGivesTheSameCurvatureOnASmoothSurface)
{
  const Surface surface(graph(6, [](double x, double y) { return -0.05 * (x * x + y * y); }));
  JetFitter fitter(surface);
  const Jet upright = fitter.nearest(centre_of(surface), {0, 0, 1});
  const Jet tilted = fitter.nearest(centre_of(surface), normalized({0.2, -0.1, 1}));
  EXPECT_NEAR(upright.tensor.k.trace(), tilted.tensor.k.trace(), 1e-4);
  EXPECT_NEAR(norm(cross(upright.tensor.normal, tilted.tensor.normal)), 0, 1e-4);
}

TEST(Jet, ResidualIsTheNoiseAndVariancesAreThoseOfTheFit)
{
  const double sigma = 0.02;
  const Surface surface(graph(
      40, [](double, double) { return 0.0; }, sigma));
  JetFitter fitter(surface);
  double residual = 0, top_degree_variance = 0, squares = 0, variance = 0, count = 0;
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
    const Vec3& p = surface.positions()[v];
    if (std::max(std::abs(p.x), std::abs(p.y)) * surface.unit() > 10) continue;
    const Jet fit = fitter.nearest(v, {0, 0, 1});
    residual += fit.residual_variance;
    top_degree_variance += fit.top_degree_variance;
    squares += std::pow(fit.tensor.k.trace() / 2, 2);
    variance += fit.mean_variance;
    ++count;
  }
  const double expected = std::pow(sigma / surface.unit(), 2);
  EXPECT_NEAR(residual / count, expected, 0.08 * expected);
  EXPECT_NEAR(top_degree_variance / count, expected, 0.08 * expected);
  EXPECT_NEAR(squares / count, variance / count * expected, 0.15 * squares / count);
}

TEST(Jet, ShapeFallsFromDegreeToDegree)
{
  const Surface surface(
      graph(12, [](double x, double y) { return 0.1 * std::sin(1.5 * x + 0.7) * std::cos(y + 0.4); }));
  const Jet fit = JetFitter(surface).nearest(centre_of(surface), {0, 0, 1});
  EXPECT_GT(fit.residual_variance, 1e-16);
  EXPECT_GT(fit.top_degree_variance, 10 * fit.residual_variance);
}

TEST(Jet, FinestIsExactUpToDegreeSix)
{
  const Surface surface(graph(8, [](double x, double y) {
    return -0.2 * x * x + 0.1 * y * y + 0.1 * x * x * x * y + 0.02 * std::pow(x, 6) - 0.03 * x * x * std::pow(y, 4);
  }));
  JetFitter fitter(surface);
  const std::size_t v = centre_of(surface);
  const Jet usual = fitter.nearest(v, {0, 0, 1}), finest = fitter.finest(v, usual);
  EXPECT_GT(std::abs(usual.tensor.k.trace() / surface.unit() - 0.2), 1e-5);
  EXPECT_NEAR(finest.tensor.k.trace() / surface.unit(), 0.2, 1e-7);
  EXPECT_LT(standard_error(finest), 1e-3 * standard_error(usual));
}

TEST(Jet, FinestTakesOneSideWhereTheCurvatureJumpsButNotAcrossAFold)
{
  const auto error_beside = [](const std::function<double(double)>& profile, double k) {
    const Surface surface(graph(10, [&](double x, double) { return profile(x); }));
    JetFitter fitter(surface);
    const std::size_t v = centre_of(surface);
    return std::abs(fitter.finest(v, fitter.nearest(v, {0, 0, 1})).tensor.k.trace() / surface.unit() - k);
  };
  constexpr double seam = 0.1, k = 0.2;  // a third of an edge beside the vertex
  EXPECT_LT(error_beside([&](double x) { return x > seam ? -k / 2 * (x - seam) * (x - seam) : 0; }, 0), 1e-6);
  EXPECT_GT(error_beside([&](double x) { return x > seam ? -k * (x - seam) : 0; }, 0), 0.03) << "a fold is an edge";
}

TEST(Jet, CovarianceOfADiscIsThatOfItsCurvatures)
{
  // At a boundary, where a quadric hardly tells the curvature across it.
  const double sigma = 0.02;
  const Vec3 axis = normalized({0.8, 0.6, 0});
  double squares[3] = {}, products[3] = {}, count = 0;
  Symmetric3 covariance;
  const Surface smooth(graph(12, [](double, double) { return 0.0; }));
  const std::size_t v = centre_of(smooth) + 12;
  std::mt19937 generator(7);
  std::normal_distribution<double> gauss(0, 1);
  for (int run = 0; run < 2000; ++run) {
    TriangleMesh mesh;
    mesh.positions = smooth.positions();
    for (Vec3& p : mesh.positions) p.z = sigma * gauss(generator);
    mesh.triangles.assign(smooth.triangles().begin(), smooth.triangles().end());
    const Surface surface(mesh);
    JetFitter fitter(surface);
    fitter.begin_disc(v, {0, 0, 1});
    const CurvatureTensor t = fitter.extend_disc(4).tensor;
    const Vec3 u = normalized(axis - t.normal * dot(axis, t.normal)), w = cross(t.normal, u);
    const double uu = quadratic_form(t.k, u), ww = quadratic_form(t.k, w), uw = dot(u, t.k * w);
    const double parts[] = {(uu + ww) / 2, (uu - ww) / 2, uw};
    for (int i = 0; i < 3; ++i) {
      squares[i] += parts[i] * parts[i];
      products[i] += parts[i] * parts[(i + 1) % 3];
    }
    covariance += fitter.disc_covariance(axis) * (sigma * sigma / (surface.unit() * surface.unit()));
    ++count;
  }
  const double expected[] = {covariance.xx, covariance.yy, covariance.zz};
  const double mixed[] = {covariance.xy, covariance.yz, covariance.xz};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(squares[i] / expected[i], 1, 0.1) << i;
    EXPECT_NEAR(products[i] / mixed[i], 1, 0.15) << i;
  }
  EXPECT_GT(std::abs(covariance.xy), 0.1 * covariance.xx) << "or nothing was tested";
}

TEST(Jet, DiscsFitAQuadricExactlyWithAllOfTheDiscOrHalf)
{
  const Surface surface(graph(12, [](double x, double y) { return -0.02 * x * x + 0.01 * y * y; }));
  JetFitter fitter(surface);
  const std::vector<double> radii{0.5, 3, 6};
  for (const std::size_t v : {centre_of(surface), centre_of(surface) + 12}) {
    const std::vector<Jet> fits = discs(fitter, v, radii);
    EXPECT_EQ(fits[0].tensor.confidence, 0) << "too few vertices";
    for (int i : {1, 2}) {
      ASSERT_EQ(fits[i].tensor.confidence, 1);
      if (v != centre_of(surface)) continue;
      EXPECT_NEAR(fits[i].tensor.k.trace() / surface.unit(), 0.02, 1e-9);
    }
    EXPECT_LT(fits[2].mean_variance, fits[1].mean_variance);
  }
  // On the boundary half of the disc is left, and the fit less sure.
  const Jet whole = discs(fitter, centre_of(surface), radii)[2],
            half = discs(fitter, centre_of(surface) + 12, radii)[2];
  EXPECT_GT(half.mean_variance, 3 * whole.mean_variance);
  EXPECT_LT(whole.centroid_offset, 0.05);
  EXPECT_NEAR(half.centroid_offset, 0.42, 0.05);
}

TEST(Jet, DiscsEndAtABarrierAndTellWhatTheyDoNotFit)
{
  const double fold = 1;  // the surface falls off beyond
  const Surface surface(graph(12, [&](double x, double) { return x > fold ? fold - x : 0.0; }));
  const std::size_t v = centre_of(surface);
  const double unit = surface.unit(), centre_x = surface.positions()[v].x;
  std::vector<char> barrier(surface.vertex_count(), 0);
  for (std::size_t u = 0; u < barrier.size(); ++u)
    barrier[u] = (surface.positions()[u].x - centre_x) * unit > fold - 0.25;
  const std::vector<double> radii{2.5, 6};
  JetFitter everywhere(surface), on_this_side(surface, barrier);
  const Jet across = discs(everywhere, v, radii)[1], within = discs(on_this_side, v, radii)[1];
  EXPECT_GT(across.residual_variance, 0.01);
  EXPECT_GT(std::abs(across.tensor.k.trace()), 0.01);
  EXPECT_NEAR(within.residual_variance, 0, 1e-12);
  EXPECT_NEAR(within.tensor.k.trace(), 0, 1e-9);
  EXPECT_GT(within.mean_variance, across.mean_variance) << "fewer vertices";
}

TEST(Jet, RoughNormalIsThatOfThePatchWhereABallSeesAnotherSheet)
{
  const std::vector<double> radii{1.5, 2.25, 3.5, 5};
  TensorField tensors(2, radii);
  const Vec3 up{0, 0, 1}, tilted = normalized({0.3, 0, 1});
  for (int i = 0; i < int(radii.size()); ++i) {
    tensors.set(0, i, {{}, tilted, 1});
    tensors.set(1, i, {{}, {0, 0, -1}, 1});
  }
  EXPECT_NEAR(norm(rough_normal(tensors, 0, up) - tilted), 0, 1e-6);
  EXPECT_NEAR(norm(rough_normal(tensors, 1, up) - up), 0, 1e-12);
}

TEST(Jet, WithoutEnoughVerticesThereIsNoFit)
{
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  const Surface surface(mesh);
  EXPECT_EQ(JetFitter(surface).nearest(0, normalized({-1, -1, -1})).tensor.confidence, 0);
}
