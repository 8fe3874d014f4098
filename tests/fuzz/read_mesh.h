// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzzing: bytes as a mesh.
#pragma once

#include "fuzz/byte_reader.h"
#include "integral_invariant/mesh/surface.h"

namespace fuzz {

/// A small mesh, up to about 200 vertices: a sphere, torus, box, sheet or loose triangles, with whatever defects the
/// bytes ask for (coordinates that are not finite, points and triangles twice, triangles turned over or without area,
/// edges with three triangles, vertices without any, indices out of range) and at any scale and distance from the
/// origin.
integral_invariant::TriangleMesh read_mesh(ByteReader& bytes);

}  // namespace fuzz
