// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the result turns with the mesh.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace accuracy {

/// For each PLY file, three rotations drawn from `seed`: the share of vertices of which a curvature moves by more than
/// 0.1, 1 and 10 % of max(|κ|, a tenth of the root mean square), and the largest move over its standard error.
/// \throw std::runtime_error where a file cannot be read
void print_frame_dependence(const std::vector<std::string>& paths, std::uint32_t seed);

}  // namespace accuracy
