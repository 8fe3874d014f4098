// SPDX-License-Identifier: GPL-3.0-or-later
// Even triangulations of exact shapes.
#pragma once

#include <functional>
#include <random>

#include "families/exact_shape.h"

namespace accuracy {

/// A closed surface that every ray from the origin meets once, within distance 4: random vertices, then relaxed.
TriangleMesh star_mesh(const Implicit& field, int vertices);

/// The surface z = height(x, y) over [−1, 1]²: rows of equilateral triangles whose inner vertices are moved at random
/// by up to a quarter of an edge.
TriangleMesh patch_mesh(const std::function<double(double, double)>& height, int vertices, std::uint32_t seed);

/// The same as scan lines: the distance between lines (along y) is `ratio` times that between points of a line.
TriangleMesh line_mesh(const std::function<double(double, double)>& height, int vertices, double ratio);

/// The torus around z with the tube's radius `tube` and distance 1 from the axis.
TriangleMesh torus_mesh(double tube, int vertices);

/// The triangles whose vertices all have y ≥ 0, and their vertices.
TriangleMesh half_of(const TriangleMesh& mesh);

}  // namespace accuracy
