// SPDX-License-Identifier: GPL-3.0-or-later
#include "fused_shapes.h"

#include <algorithm>
#include <cmath>

namespace samples {
namespace {

constexpr double knob_height = 0.16;   // of the sphere's radius
constexpr double knob_sharpness = 22;  // inverse square of the knob's angular width
constexpr double fillet = 0.35;        // width of the join, in radii of the smaller shape
constexpr double furthest = (1 + knob_height) * 1.01;

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

const std::vector<Point>& icosahedron()
{
  static const std::vector<Point> vertices = [] {
    const double golden = (1 + std::sqrt(5.0)) / 2, length = std::sqrt(1 + golden * golden);
    std::vector<Point> result;
    for (double a : {-1.0, 1.0})
      for (double b : {-golden, golden}) {
        const double s = a / length, t = b / length;
        result.insert(result.end(), {{0, s, t}, {s, t, 0}, {t, 0, s}});
      }
    return result;
  }();
  return vertices;
}

Point in_frame_of(const KnobbySphere& shape, const Point& p)
{
  const double x = p[0] - shape.centre[0], y = p[1] - shape.centre[1], z = p[2] - shape.centre[2];
  const double c = std::cos(shape.tilt), s = std::sin(shape.tilt);
  return {c * x + s * y, c * y - s * x, z};
}

double value(const KnobbySphere& shape, const Point& p)
{
  const Point q = in_frame_of(shape, p);
  const double length = std::sqrt(dot(q, q));
  // Far from the surface only the sign matters, and the knobs are what takes the time.
  if (length < 0.5 * shape.radius || length > 2 * shape.radius) return length - shape.radius;
  double height = 1;
  for (const Point& v : icosahedron()) height += knob_height * std::exp(knob_sharpness * (dot(q, v) / length - 1));
  return length - shape.radius * height;
}

/// Minimum of a and b whose edge is rounded over the width k; a polynomial of second degree there.
double smooth_minimum(double a, double b, double k)
{
  const double overlap = std::max(k - std::abs(a - b), 0.0);
  return std::min(a, b) - overlap * overlap / (4 * k);
}

KnobbySphere copy_on(const KnobbySphere& base, const Point& direction, double scale, double tilt)
{
  const double radius = base.radius * scale;
  const double length = std::sqrt(dot(direction, direction));
  const double distance = (base.radius + 0.85 * radius) / length;
  return {{base.centre[0] + distance * direction[0], base.centre[1] + distance * direction[1],
           base.centre[2] + distance * direction[2]},
          radius,
          tilt};
}

}  // namespace

double FusedShapes::operator()(const Point& p) const
{
  double result = value(shapes_.front(), p);
  for (std::size_t i = 1; i < shapes_.size(); ++i)
    result = smooth_minimum(result, value(shapes_[i], p), fillet * shapes_[i].radius);
  return result;
}

double FusedShapes::extent() const
{
  double result = 0;
  const Point& origin = shapes_.front().centre;
  for (const KnobbySphere& shape : shapes_) {
    const Point d = {shape.centre[0] - origin[0], shape.centre[1] - origin[1], shape.centre[2] - origin[2]};
    result = std::max(result, std::sqrt(dot(d, d)) + furthest * shape.radius);
  }
  return result;
}

Point FusedShapes::gradient(const Point& p) const
{
  const double h = 1e-5 * shapes_.front().radius;
  Point result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Point low = p, high = p;
    low[axis] -= h;
    high[axis] += h;
    result[axis] = ((*this)(high) - (*this)(low)) / (2 * h);
  }
  return result;
}

Point FusedShapes::projected(Point p) const
{
  constexpr int newton_steps = 4;  // from a fraction of a grid cell away, two are enough
  for (int step = 0; step < newton_steps; ++step) {
    const Point g = gradient(p);
    const double along = (*this)(p) / std::max(dot(g, g), 1e-6);
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] -= along * g[axis];
  }
  return p;
}

FusedShapes sample_solid()
{
  constexpr double middle_scale = 1 / 3.0, small_scale = 1 / 8.0;
  const KnobbySphere large{{0, 0, 0}, 1, 0};
  const KnobbySphere middle = copy_on(large, {0.85, 0.40, 0.42}, middle_scale, 0.4);
  const KnobbySphere small = copy_on(large, {-0.12, 0.50, 0.86}, small_scale, 0.9);
  const KnobbySphere small_on_middle = copy_on(middle, {-0.25, 0.9, 0.4}, small_scale / middle_scale, 1.7);
  return FusedShapes({large, middle, small, small_on_middle});
}

}  // namespace samples
