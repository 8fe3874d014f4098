// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes whose ridges and lines of curvature are known, and exact curvature fields on them.
#pragma once

#include "integral_invariant/features/curvature_field.h"
#include "support/shapes.h"

namespace test_support {

/// x²/a² + y²/b² + z²/c² = 1 on a subdivided icosahedron.
TriangleMesh ellipsoid(int levels, Vec3 half_axes);

/// The exact principal curvatures and directions of the ellipsoid at the vertices, in the caller's unit.
integral_invariant::Result ellipsoid_curvature(const TriangleMesh& mesh, Vec3 half_axes);

/// The same of the torus() with these radii.
integral_invariant::Result torus_curvature(const TriangleMesh& mesh, double major_radius, double tube_radius);

/// The four umbilics of the ellipsoid a > b > c.
std::vector<Vec3> ellipsoid_umbilics(Vec3 half_axes);

/// The confocal coordinates (μ in [c², b²], ν in [b², a²]) of the point of the ellipsoid a > b > c next to `p`. Along a
/// line of curvature of the family of κ_max ν is constant, along one of κ_min μ is.
struct Confocal {
  double mu, nu;
};
Confocal confocal_coordinates(Vec3 p, Vec3 half_axes);

/// Closed box [0, length]² × [0, height] whose top carries the ridge `ridge_height` exp(−(x − x₀)²/(2 width²)) along y:
/// its crest at x = x₀ has the radius width²/ridge_height. A negative height makes a valley.
TriangleMesh box_with_ridge(double length, double height, double step, double x0, double ridge_height, double width);

}  // namespace test_support
