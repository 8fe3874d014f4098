// SPDX-License-Identifier: GPL-3.0-or-later
// A solid with features of clearly different size, as an implicit function.
#pragma once

#include <array>
#include <vector>

namespace samples {

using Point = std::array<double, 3>;

/// A sphere with twelve round knobs, one on each vertex of an icosahedron.
struct KnobbySphere {
  Point centre;
  double radius;
  double tilt;  ///< rotation about the z axis, so that copies do not look like one another
};

/// The union of knobby spheres, each smoothly joined to those before it. The first is the largest.
class FusedShapes {
 public:
  explicit FusedShapes(std::vector<KnobbySphere> shapes) : shapes_(std::move(shapes)) {}

  /// About the distance to the surface; negative inside.
  double operator()(const Point& p) const;
  /// Radius of a ball around the first centre that holds the solid.
  double extent() const;
  /// p moved along the gradient onto the zero set.
  Point projected(Point p) const;

 private:
  Point gradient(const Point& p) const;

  std::vector<KnobbySphere> shapes_;
};

/// A unit sphere, its copies at the scales 1 : 3 and 1 : 8 on it, and one more of 1 : 8 on that of 1 : 3.
FusedShapes sample_solid();

}  // namespace samples
