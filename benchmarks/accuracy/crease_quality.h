// SPDX-License-Identifier: GPL-3.0-or-later
// CAD models as they are: even values along creases, and flats that read flat.
#pragma once

#include <string>
#include <vector>

namespace accuracy {

/// For each PLY file, for the default settings and the published method. A crease is an edge whose triangles meet at
/// 40 degrees or more; neighbours along it are its ends. Printed: the share of such neighbours whose curvatures of
/// largest size differ by more than 2×; of the flat vertices (all triangles within half a degree) the share that reads
/// |H| ē > 0.05; and the share of their errors, of either curvature, within three standard errors, all flat vertices
/// and those that read wrong. \throw std::runtime_error where a file cannot be read
void print_crease_quality(const std::vector<std::string>& paths);

}  // namespace accuracy
