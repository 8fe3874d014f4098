// SPDX-License-Identifier: GPL-3.0-or-later
// A cell vertex by vertex: what learned_bound.py is taught with and judged by.
#pragma once

#include "truth.h"

namespace accuracy {

/// One line a vertex: place on the exact surface, true normal, how far noise moved it along that normal, true κ, the
/// value errors are relative to, role (0 its truth is not known, 1 it is, 2 it is judged). In average edge lengths of
/// the exact mesh, and their inverse.
void print_vertices(const TruthMesh& truth, const TriangleMesh& noisy);

}  // namespace accuracy
