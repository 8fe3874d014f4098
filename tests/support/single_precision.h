// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as programs that keep coordinates in single precision hand them on.
#pragma once

#include "integral_invariant/mesh.h"

namespace test_support {

inline integral_invariant::TriangleMesh in_single_precision(integral_invariant::TriangleMesh mesh)
{
  for (integral_invariant::Vec3& p : mesh.positions) p = {double(float(p.x)), double(float(p.y)), double(float(p.z))};
  return mesh;
}

}  // namespace test_support
