// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that are known as zero sets of functions, so that any mesh near them can be judged.
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
  Implicit field;           ///< zero on the surface, grows outward; smooth but at seams
  Box domain;               ///< holds the surface; an open one ends at its faces
  /// About so many vertices on the surface, edges of nearly equal length.
  std::function<TriangleMesh(int vertices)> mesh;
  /// Distance to where the curvature jumps; empty: it does so nowhere.
  std::function<double(const Vec3&)> seam_distance;
  bool is_height_field = false;  ///< z over x and y
};

Vec3 gradient_of(const Implicit& field, const Vec3& p);

/// The nearest point of the zero set, for `p` near it.
Vec3 project(const Implicit& field, const Vec3& p);

/// The mesh with the truth of 800 of its vertices, drawn at random, at the nearest point of the exact surface. Not
/// drawn are vertices on a rim and next to one, and those within three edges of a seam.
TruthMesh judge_at_projections(const ExactShape& shape, TriangleMesh mesh);

}  // namespace accuracy
