// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials are found again, and the variances of the fits are those of the closed forms.
#include "integral_invariant/drawing/local_regression.h"

#include <gtest/gtest.h>

using namespace integral_invariant;

namespace {

double weight_at(double x, double y, double width) { return std::exp(-(x * x + y * y) / (2 * width * width)); }

/// A grid of step 0.1 over ±6, weights of the width 1.
template <int degree, class Function>
LocalRegression<degree, 1> on_the_plane(const Function& f, double first_x = -6)
{
  LocalRegression<degree, 1> regression;
  for (int i = -60; i <= 60; ++i)
    for (int j = -60; j <= 60; ++j)
      if (const double x = 0.1 * i, y = 0.1 * j; x >= first_x) regression.add({x, y}, weight_at(x, y, 1), {f(x, y)});
  return regression;
}

}  // namespace

TEST(LocalRegression, FindsAPolynomialAgain)
{
  const auto f = [](double x, double y) { return 3 - x + 2 * y + 0.5 * x * x - 0.25 * x * y + 4 * y * y; };
  const LocalFit fit = on_the_plane<2>(f, 0.5).solve()[0];
  EXPECT_NEAR(fit.value, 3, 1e-9);
  EXPECT_NEAR(fit.slope[0], -1, 1e-9);
  EXPECT_NEAR(fit.slope[1], 2, 1e-9);
  EXPECT_NEAR(fit({1.5, -2}), f(1.5, -2), 1e-9);
}

TEST(LocalRegression, FitsALowerDegreeWhereThePlacesTellNoMore)
{
  LocalRegression<2, 1> three;
  three.add({0, 0}, 1, {1});
  three.add({1, 0}, 1, {2});
  three.add({0, 1}, 1, {4});
  const LocalFit plane = three.solve()[0];
  EXPECT_NEAR(plane({1, 0}), 2, 1e-12);
  EXPECT_NEAR(plane({0, 1}), 4, 1e-12);
  LocalRegression<2, 1> two;
  two.add({-1, 0}, 1, {1});
  two.add({1, 0}, 1, {2});
  EXPECT_NEAR(two.solve()[0].value, 1.5, 1e-12);
  EXPECT_EQ((LocalRegression<2, 1>().solve()[0].value), 0);
}

TEST(LocalRegression, VariancesAreThoseOfGaussianWeights)
{
  const auto zero = [](double, double) { return 0.0; };
  auto linear = on_the_plane<1>(zero);
  linear.solve();
  EXPECT_NEAR(linear.variance().value, 1, 1e-6);
  EXPECT_NEAR(linear.variance().slope, 1, 1e-6);
  auto quadratic = on_the_plane<2>(zero);
  quadratic.solve();
  EXPECT_NEAR(quadratic.variance().value, 2, 1e-6);
  EXPECT_NEAR(quadratic.variance().slope, 1, 1e-6);
  auto half = on_the_plane<2>(zero, 0);
  half.solve();
  EXPECT_GT(half.variance().value, 4) << "at a boundary a fit is less certain";
}

TEST(LocalRegression, ErrorsOfCorrelatedValuesHaveTheirLimits)
{
  const FitVariance on_plane{2, 0.25};  // weights of the width 2
  // Errors that are alike everywhere: the value has all of them, the slope none.
  EXPECT_NEAR(fit_error(2, 1e3, on_plane).value, 1, 1e-3);
  EXPECT_NEAR(fit_error(2, 1e3, on_plane).slope, 0, 1e-2);
  // White noise: with ℓ → 0 the linear value's variance is ℓ²/(2R²), the quadratic one's 2.5 times that.
  const double white = 0.01 * 0.01 / 8;
  EXPECT_NEAR(std::pow(fit_error(1, 0.01, {1, 0.25}).value, 2), white, 1e-4 * white);
  EXPECT_NEAR(std::pow(fit_error(2, 0.01, on_plane).value, 2), 2.5 * white, 1e-4 * white);
  EXPECT_NEAR(std::pow(fit_error(2, 0.01, on_plane).slope, 2), white / 8, 1e-4 * white);
}
