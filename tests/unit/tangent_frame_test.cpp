// SPDX-License-Identifier: GPL-3.0-or-later
// Tensors in the frame of another tangent plane.
#include "integral_invariant/ball_curvature/tangent_frame.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace integral_invariant;

namespace {

TangentFrame some_frame()
{
  const Vec3 normal = normalized({0.3, -0.5, 0.8}), u = any_orthogonal(normal);
  return {normal, u, cross(normal, u)};
}

}  // namespace

TEST(TangentFrame, ComponentsAreThoseOfTheTensorThereAndBack)
{
  const TangentFrame frame = some_frame();
  const TensorComponents components{0.4, {0.2, -0.1}, {0.15, -0.25}};
  const CurvatureTensor tensor = tensor_of(components, frame);
  EXPECT_NEAR(norm(tensor.normal), 1, 1e-12);
  EXPECT_NEAR(norm(tensor.k * tensor.normal), 0, 1e-12);
  const PrincipalCurvatures k = principal_curvatures(tensor);
  EXPECT_NEAR((k.kappa_max + k.kappa_min) / 2, 0.4, 1e-12);
  EXPECT_NEAR((k.kappa_max - k.kappa_min) / 2, std::hypot(0.2, 0.1), 1e-12);
  const TensorComponents back = components_of(tensor, frame);
  EXPECT_NEAR(back.mean, components.mean, 1e-12);
  for (int c : {0, 1}) {
    EXPECT_NEAR(back.deviator[c], components.deviator[c], 1e-12);
    EXPECT_NEAR(back.tilt[c], components.tilt[c], 1e-12);
  }
}

TEST(TangentFrame, CovarianceTurnsAsTheComponentsDo)
{
  const TangentFrame frame = some_frame();
  const double angle = 0.7, x = std::cos(angle), y = std::sin(angle);
  const TangentFrame turned_frame{frame.normal, frame.u * x + frame.v * y, frame.v * x - frame.u * y};
  // Of one direction of error alone: the outer product of its components.
  const auto outer_of = [](const TensorComponents& c) { return outer({c.mean, c.deviator[0], c.deviator[1]}); };
  const CurvatureTensor error = tensor_of({0.3, {0.5, -0.2}, {}}, frame);
  const Symmetric3 expected = outer_of(components_of(error, turned_frame)),
                   turned = rotate_covariance(outer_of(components_of(error, frame)), 2 * x, 2 * y);
  const Symmetric3 difference = turned - expected;
  for (const double d : {difference.xx, difference.xy, difference.xz, difference.yy, difference.yz, difference.zz})
    EXPECT_NEAR(d, 0, 1e-12);
}
