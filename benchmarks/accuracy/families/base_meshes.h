// SPDX-License-Identifier: GPL-3.0-or-later
// Even triangulations of exact shapes.
#pragma once

#include <functional>
#include <random>

#include "families/exact_shape.h"

namespace accuracy {

/// Of a closed surface that every ray from the origin meets once, within distance 4: vertices at random, then evened.
TriangleMesh star_mesh(const Implicit& field, int vertices);

/// Of z = height(x, y) over [−1, 1]²: rows of equilateral triangles, their inner vertices moved at random by up to a
/// quarter of an edge.
TriangleMesh patch_mesh(const std::function<double(double, double)>& height, int vertices, std::uint32_t seed);

/// The same in lines: `ratio` times as far from line to line (along y) as from point to point within one.
TriangleMesh line_mesh(const std::function<double(double, double)>& height, int vertices, double ratio);

/// The torus around z with the tube's radius `tube` and distance 1 from the axis.
TriangleMesh torus_mesh(double tube, int vertices);

/// The part of the mesh whose vertices all have y ≥ 0, without the vertices that are left over.
TriangleMesh half_of(const TriangleMesh& mesh);

}  // namespace accuracy
