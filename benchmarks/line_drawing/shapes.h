// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes given by a map of the plane, in units of the average edge, with their meshes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "integral_invariant/mesh.h"

namespace line_benchmark {

using integral_invariant::TriangleMesh;
using integral_invariant::Vec3;

struct Shape {
  std::string name;
  std::function<Vec3(double s, double t)> position;  ///< the outward normal is along ∂position/∂s × ∂position/∂t
  double s_end = 1, t_end = 1;                       ///< of the parameters, which begin at s_begin and t_begin
  double s_begin = 0, t_begin = 0;
  double margin = 0;  ///< ē: of the mesh's boundary, where nothing is judged
  TriangleMesh mesh;
};

Shape torus_shape();      ///< R = 3 r, 22,400 vertices
Shape ellipsoid_shape();  ///< 2 : 1.4 : 0.8
Shape sphere_shape();     ///< 10,242 vertices
/// The graph of z = height(x, y) over the square of ±48 ē.
Shape height_field(const std::string& name, const std::function<double(double, double)>& height);

/// The mesh with noise along the normals, in units of ē: Gaussian, and correlated over `correlation` where that is over
/// 0 (white noise averaged with Gaussian weights of that standard deviation, brought back to sigma).
TriangleMesh with_noise(const TriangleMesh& mesh, double sigma, double correlation, std::uint32_t seed);

}  // namespace line_benchmark
