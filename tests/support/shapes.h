// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes whose curvature is known.
#pragma once

#include <cstdint>

#include "integral_invariant/mesh/surface.h"

namespace test_support {

using integral_invariant::TriangleMesh;
using integral_invariant::Vec3;

/// Icosahedron subdivided `levels` times, vertices on the sphere: 10·4^levels + 2 vertices.
TriangleMesh icosphere(int levels, double radius = 1, Vec3 centre = {});

/// Icosphere with its radius between 0.8 and 1.2: bumps and hollows as wide as itself.
TriangleMesh bumpy_sphere(int levels);

/// Torus around z with nu × nv vertices (nu even), nearly equilateral triangles: u around the axis, v around the tube.
TriangleMesh torus(double major_radius, double tube_radius, int nu, int nv);
/// Principal curvature around the axis at angle v around the tube; the other one is 1/tube_radius.
double torus_curvature_around_axis(double major_radius, double tube_radius, double v);

/// Closed box [0,a]×[0,b]×[0,c], each side a grid of squares of about `step`, cut into triangles; vertices are shared.
TriangleMesh box(double a, double b, double c, double step);

/// Closed cylinder around z between ±height/2 with flat caps, triangles of about `step`.
TriangleMesh cylinder(double radius, double height, double step);

/// Adds Gaussian noise of standard deviation `sigma` along the vertex normals; same seed, same noise.
TriangleMesh with_normal_noise(TriangleMesh mesh, double sigma, std::uint32_t seed = 1);

/// Moves each vertex by a uniform random vector of length up to `amount` within the tangent plane of its normal.
TriangleMesh with_tangential_jitter(TriangleMesh mesh, double amount, std::uint32_t seed = 1);

/// Second mesh appended to the first.
TriangleMesh joined(TriangleMesh a, const TriangleMesh& b);
TriangleMesh translated(TriangleMesh mesh, Vec3 by);
TriangleMesh scaled(TriangleMesh mesh, double factor);
/// Rotated by `angle` about the unit vector `axis`.
TriangleMesh rotated(TriangleMesh mesh, Vec3 axis, double angle);
Vec3 rotated(const Vec3& v, const Vec3& axis, double angle);
TriangleMesh flipped(TriangleMesh mesh);

double average_edge_length(const TriangleMesh& mesh);
double bounding_box_diagonal(const TriangleMesh& mesh);
/// Area-weighted unit normals; zero where a vertex has no triangle.
std::vector<Vec3> vertex_normals(const TriangleMesh& mesh);

}  // namespace test_support
