// SPDX-License-Identifier: GPL-3.0-or-later
// The gap of a fan is closed in the tangent plane, on the side where the surface is missing.
#include <gtest/gtest.h>

#include <cmath>

#include "integral_invariant/moments/surface/fan_closure.h"

using namespace integral_invariant;

namespace {

FanRay ray(double degrees, bool arriving)
{
  const double a = degrees * 3.14159265358979323846 / 180;
  return {{std::cos(a), std::sin(a), 0}, arriving};
}

double gap_degrees(std::vector<FanRay> rays)
{
  double gap = 0;
  const auto arcs = close_fans(rays, {0, 0, 1}, gap);
  for (const auto& arc : arcs) EXPECT_GT(dot(arc.first, arc.second), -0.1);
  return gap * 180 / 3.14159265358979323846;
}

}  // namespace

TEST(VertexFan, HalfPlane) { EXPECT_NEAR(gap_degrees({ray(10, false), ray(190, true)}), 180, 1e-9); }
TEST(VertexFan, OneTriangle) { EXPECT_NEAR(gap_degrees({ray(-20, false), ray(40, true)}), 300, 1e-9); }
TEST(VertexFan, Slit) { EXPECT_NEAR(gap_degrees({ray(90, false), ray(89, true)}), 0, 1e-9); }
TEST(VertexFan, TwoFansCloseFromOneToTheNext)
{
  EXPECT_NEAR(gap_degrees({ray(0, false), ray(60, true), ray(150, false), ray(300, true)}), 150, 1e-9);
}
TEST(VertexFan, CoincidingRaysAtTheCutOfTheAngle)
{
  EXPECT_NEAR(gap_degrees({ray(179.9, false), ray(-179.9, true), ray(0.1, true), ray(0, false)}), 0, 1e-9);
}
