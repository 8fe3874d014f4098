// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzzing: bytes as a mesh.
#pragma once

#include "fuzz/byte_reader.h"
#include "integral_invariant/mesh/surface.h"

namespace fuzz {

/// A small mesh, mostly up to 200 vertices, 2000 where nothing is joined: a sphere, torus, box, sheet or loose
/// triangles, with whatever defects the bytes ask for (coordinates that are not finite, points and triangles twice,
/// triangles turned over or without area, edges with three triangles, vertices without any, indices out of range), at
/// any scale and distance from the origin, unwelded, of mixed sizes, with long and thin triangles.
integral_invariant::TriangleMesh read_mesh(ByteReader& bytes);

}  // namespace fuzz
