// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sphere_meshes.h"

namespace accuracy {

/// The analytic shapes of the benchmark.
std::vector<std::string> shape_names();
/// The shapes that can also be meshed irregularly, graded and with slivers.
bool is_star_shaped(const std::string& name);
TruthMesh make_shape(const std::string& name, Meshing meshing);

}  // namespace accuracy
