// SPDX-License-Identifier: GPL-3.0-or-later
// VCG's marching cubes and remeshing on an implicit solid. polygonise.cpp is the only file here that includes VCG.
#pragma once

#include <cstddef>
#include <string>

#include "fused_shapes.h"

namespace samples {

struct MeshSize {
  std::size_t vertices, triangles;
};

/// Writes the surface of `solid` as a binary PLY: closed, oriented outward, triangles near equilateral with edges of
/// about `edge`. \throw std::runtime_error where the mesh did not come out so, or the file cannot be written
MeshSize polygonise(const FusedShapes& solid, double edge, const std::string& ply_file);

}  // namespace samples
