// SPDX-License-Identifier: GPL-3.0-or-later
// The multi-scale signature against the volumes of two balls' intersection, and its reductions.
#include "integral_invariant/features/signature.h"

#include <gtest/gtest.h>

#include <cmath>

#include "integral_invariant/error.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

Signature made_up(std::vector<std::vector<float>> volume)
{
  Signature signature;
  signature.values[0] = std::move(volume);
  return signature;
}

}  // namespace

TEST(Signature, OfASphereHasTheVolumesOfTwoBallsIntersection)
{
  const double big = 1;
  const TriangleMesh mesh = icosphere(5, big);
  Parameters p;
  p.scales = 5;
  p.r_min = 0.15;
  p.r_max = 0.45;
  p.engine = EngineKind::surface_integral;
  const Signature signature = compute_signature(mesh, p);
  ASSERT_EQ(signature.radii.size(), 5u);
  for (std::size_t s = 0; s < 5; ++s) {
    const double r = signature.radii[s];
    EXPECT_NEAR(r, 0.15 + 0.075 * double(s), 1e-12);
    for (std::size_t v = 0; v < mesh.positions.size(); v += 17) {
      // A ball centred on a sphere of radius R: V = 2π/3 r³ − π r⁴/(4R), so the invariant is 3r/(8R).
      EXPECT_NEAR(signature.of(SignatureQuantity::volume)[s][v], 3 * r / (8 * big), 0.005);
      EXPECT_NEAR(signature.of(SignatureQuantity::mean)[s][v], 1 / big, 0.05);
      EXPECT_NEAR(signature.of(SignatureQuantity::difference)[s][v], 0, 0.02);
    }
  }
}

TEST(Signature, IsNegativeInAHollowAndPositiveOnACorner)
{
  const TriangleMesh mesh = box(1, 1, 1, 0.05);
  Parameters p;
  p.scales = 2;
  p.r_min = 0.2;
  p.r_max = 0.4;
  const Signature signature = compute_signature(mesh, p);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    if (norm(mesh.positions[v]) < 1e-9)  // one eighth of the ball is solid: 1 − 2/8
      for (const auto& scale : signature.of(SignatureQuantity::volume)) { EXPECT_NEAR(scale[v], 0.75, 0.03); }
  const Signature inside =
      compute_signature(joined(box(3, 3, 3, 0.2), translated(flipped(icosphere(3, 1)), {1.5, 1.5, 1.5})), p);
  EXPECT_LT(inside.of(SignatureQuantity::volume)[0].back(), -0.02);
}

TEST(Signature, Reductions)
{
  const Signature signature = made_up({{-1, 0.5F}, {3, 0.25F}, {2, 0}});
  ReductionParameters p;
  p.scale = 2;
  EXPECT_EQ(reduce(signature, p), (std::vector<double>{3, 0.25}));
  p.reduction = Reduction::minimum;
  EXPECT_EQ(reduce(signature, p), (std::vector<double>{-1, 0}));
  p.reduction = Reduction::maximum;
  EXPECT_EQ(reduce(signature, p), (std::vector<double>{3, 0.5}));
  p.reduction = Reduction::p_norm;
  EXPECT_NEAR(reduce(signature, p)[0], std::sqrt(14.0 / 3), 1e-9);
  p.p = 1000;
  EXPECT_NEAR(reduce(signature, p)[0], 3, 0.01);
}

TEST(Signature, RefusesScalesThatAreNotThere)
{
  const Signature signature = made_up({{1}, {2}});
  ReductionParameters p;
  for (const int scale : {0, 3}) {
    p.scale = scale;
    EXPECT_THROW(reduce(signature, p), ParameterError);
  }
  p.reduction = Reduction::p_norm;
  p.p = 0.5;
  EXPECT_THROW(reduce(signature, p), ParameterError);
}
