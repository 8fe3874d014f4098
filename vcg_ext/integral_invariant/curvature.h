// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integral_invariant/error.h"
#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/parameters.h"
#include "integral_invariant/result.h"

namespace integral_invariant {

/// Principal curvatures, directions and feature-adapted radius of every vertex of `mesh` [Lai09]; with a fixed radius,
/// those of [Yang06].
///
/// The result does not depend on the number of threads, nor on the order of vertices, faces and corners within a face,
/// not in a single bit; but vertices at the same place are told apart by their order. `progress` is called from this
/// thread only. \throw ParameterError, InputError, MemoryError with a sentence for the user; Cancelled when `progress`
/// returned false
Result compute_curvature(const TriangleMesh& mesh, const Parameters& parameters, const ProgressCallback& progress = {});

}  // namespace integral_invariant
