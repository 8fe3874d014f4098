// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces given as zero sets of functions, so that any mesh near them can be judged.
#pragma once

#include <functional>
#include <string>

#include "implicit_curvature.h"
#include "integral_invariant/mesh.h"
#include "truth.h"

namespace accuracy {

using integral_invariant::Box;

struct ExactShape {
  std::string name, group;  ///< group: smooth, bumpy, cad, open
  Implicit field;           ///< zero on the surface, increasing outward; smooth except at seams
  Box domain;               ///< encloses the surface; an open surface ends at its faces
  /// A mesh of about so many vertices on the surface with nearly equal edges.
  std::function<TriangleMesh(int vertices)> mesh;
  /// Distance to the nearest jump of the curvature; empty if it is continuous.
  std::function<double(const Vec3&)> seam_distance;
  bool is_height_field = false;  ///< z = height(x, y)
};

Vec3 gradient_of(const Implicit& field, const Vec3& p);

/// The nearest point of the zero set, for `p` near it.
Vec3 project(const Implicit& field, const Vec3& p);

/// Judges 800 random vertices of the mesh by the curvature at the nearest point of the exact surface. Vertices on or
/// next to a boundary and within three edges of a seam are not judged.
TruthMesh judge_at_projections(const ExactShape& shape, TriangleMesh mesh);

}  // namespace accuracy
