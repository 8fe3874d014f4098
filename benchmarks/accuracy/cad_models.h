// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "truth.h"

namespace accuracy {

/// Models with exact curvatures, of at most 25,000 vertices.
std::vector<std::string> cad_model_names();

/// Reads folder/name.ply: little-endian vertices with x y z, normal, k1 k2, d1, d2 and `ring`, the distance in edges to
/// the nearest edge of the CAD surface (0: no truth there). Vertices with ring ≥ 3 are judged.
/// \throw std::runtime_error if the file has another layout
TruthMesh load_cad_model(const std::string& folder, const std::string& name);

}  // namespace accuracy
