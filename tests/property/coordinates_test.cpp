// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates of any size, far from the origin, and in single precision: what docs/robustness.md promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "integral_invariant/curvature.h"
#include "integral_invariant/error.h"
#include "support/shapes.h"
#include "support/single_precision.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

TriangleMesh sample() { return with_normal_noise(torus(2, 0.6, 100, 30), 0.005); }

struct Difference {
  double largest = 0, root_mean_square = 0;
};

/// Of both curvatures of `b` times `scale` from those of `a`, relative to the root mean square of a's κ_max.
Difference difference(const Result& a, const Result& b, double scale = 1)
{
  double square = 0, sum = 0;
  Difference d;
  for (std::size_t v = 0; v < a.kappa_max.size(); ++v) {
    square += a.kappa_max[v] * a.kappa_max[v];
    for (const double off : {a.kappa_max[v] - b.kappa_max[v] * scale, a.kappa_min[v] - b.kappa_min[v] * scale}) {
      d.largest = std::max(d.largest, std::abs(off));
      sum += off * off / 2;
    }
  }
  return {d.largest / std::sqrt(square / double(a.kappa_max.size())), std::sqrt(sum / square)};
}

struct Case {
  EngineKind engine;
  RadiusChoice choice;
};

class Coordinates : public testing::TestWithParam<Case> {
 protected:
  Result run(const TriangleMesh& mesh) const
  {
    Parameters p;
    p.engine = GetParam().engine;
    p.radius_choice = GetParam().choice;
    return compute_curvature(mesh, p, {});
  }
  void expect_within(double tolerance, const TriangleMesh& mesh, double scale = 1) const
  {
    const Difference d = difference(run(sample()), run(mesh), scale);
    EXPECT_LT(d.root_mean_square, tolerance) << "largest " << d.largest;
  }
};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Runs, Coordinates,
                         testing::Values(Case{EngineKind::surface_integral, RadiusChoice::statistical},
                                         Case{EngineKind::surface_integral, RadiusChoice::feature_adapted},
                                         Case{EngineKind::volume_fft, RadiusChoice::statistical}));

TEST_P(Coordinates, OfAnySizeGiveTheSameShape)
{
  for (const double scale : {1e-20, 1e-6, 1e6, 1e15}) expect_within(1e-7, scaled(sample(), scale), scale);
}

TEST_P(Coordinates, AHundredMillionFromTheOrigin) { expect_within(3e-6, translated(sample(), {1e8, -1e8, 1e8})); }

TEST_P(Coordinates, InSinglePrecision) { expect_within(3e-5, in_single_precision(sample())); }

TEST_P(Coordinates, InSinglePrecisionAHundredSizesFromTheOrigin)
{
  expect_within(3e-4, in_single_precision(translated(sample(), {500, -500, 500})));
}

TEST(CoordinatesRefused, WhenSinglePrecisionHoldsNothingOfTheShape)
{
  // At 1e8 single precision has steps of 8, and the whole torus falls into one point.
  EXPECT_THROW(compute_curvature(in_single_precision(translated(sample(), {1e8, 1e8, 1e8})), {}, {}), InputError);
}
