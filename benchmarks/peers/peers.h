// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature estimators of other libraries for the speed benchmark: one thread, default settings.
#pragma once

#include "integral_invariant/mesh/surface.h"

namespace peers {

/// Each returns the mean of |κ_max| over the vertices, so that the compiler cannot drop any work.

/// VCG's fit of a quadric to the 1-ring (MeshLab: quadric fitting).
double vcg_quadric(const integral_invariant::TriangleMesh& mesh);
/// VCG's fit of a quadric to the vertices within `radius` (MeshLab: scale dependent quadric fitting).
double vcg_scale_dependent_quadric(const integral_invariant::TriangleMesh& mesh, double radius);
/// CGAL's jet of degree 2 through the vertices within `radius`.
double cgal_jet(const integral_invariant::TriangleMesh& mesh, double radius);

}  // namespace peers
