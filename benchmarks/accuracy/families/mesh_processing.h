// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh processing that only needs the neighbours of a vertex.
#pragma once

#include "integral_invariant/mesh.h"

namespace accuracy {

/// One Laplacian pass: every vertex moves the fraction `factor` of the way to the mean of its neighbours; boundaries
/// stay.
void smooth(integral_invariant::TriangleMesh& mesh, double factor);

/// Each triangle into four, the new vertices at the middle of the edges.
integral_invariant::TriangleMesh midpoint_subdivided(const integral_invariant::TriangleMesh& mesh);

/// One step of Loop's scheme, with its rules for rims.
integral_invariant::TriangleMesh loop_subdivided(const integral_invariant::TriangleMesh& mesh);

}  // namespace accuracy
