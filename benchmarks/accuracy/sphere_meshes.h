// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulations of the unit sphere, to be moved onto star-shaped surfaces.
#pragma once

#include <string>

#include "truth.h"

namespace accuracy {

enum class Meshing { regular, irregular, graded, slivers };
std::string name_of(Meshing meshing);

/// About `vertices` vertices on the unit sphere (regular: 10·4^k + 2 near that), oriented outward, always the same:
/// irregular: random places with a least distance; graded: edges that grow by 6 from one pole to the other;
/// slivers: a third of the vertices of a regular mesh have a twin at 0.15 of the edge length.
TriangleMesh sphere_mesh(Meshing meshing, int vertices);

/// The irregular mesh without a cap of angle `angle` about +z; the first `rim` vertices stand around it,
/// counterclockwise.
TriangleMesh sphere_mesh_with_hole(int vertices, double angle, int rim);

}  // namespace accuracy
