// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh processing by VCG, as MeshLab's filters do it.
#pragma once

#include "integral_invariant/mesh.h"

namespace accuracy {

/// Quadric edge collapse down to about `vertices` vertices.
integral_invariant::TriangleMesh decimated(const integral_invariant::TriangleMesh& mesh, int vertices);

/// Isotropic explicit remeshing to the edge length `edge`, with projection onto the input.
integral_invariant::TriangleMesh isotropically_remeshed(const integral_invariant::TriangleMesh& mesh, double edge);

}  // namespace accuracy
