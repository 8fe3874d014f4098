// SPDX-License-Identifier: GPL-3.0-or-later
// What VCG, and with it MeshLab, does to meshes.
#pragma once

#include "integral_invariant/mesh.h"

namespace accuracy {

/// Quadric edge collapse down to `vertices` vertices, about.
integral_invariant::TriangleMesh decimated(const integral_invariant::TriangleMesh& mesh, int vertices);

/// Isotropic explicit remeshing with edges of length `edge`, its vertices projected to the mesh.
integral_invariant::TriangleMesh isotropically_remeshed(const integral_invariant::TriangleMesh& mesh, double edge);

}  // namespace accuracy
