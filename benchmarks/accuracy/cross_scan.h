// SPDX-License-Identifier: GPL-3.0-or-later
// Judged without a truth: what a method reads in one scan must predict what is measured in another of the same surface.
#pragma once

#include <string>

namespace accuracy {

/// Prints R² = 1 − mean (H_A − t)² / var t for the default settings and for constant radii, against four targets t:
/// nearly unbiased, noisy readings of scan B at the vertices nearest to those of scan A. Mean over the six ordered
/// pairs of bun000 with bun045, bun315 and chin in `folder`. Only vertices whose partner is within one edge, with
/// normals within 32 degrees, both at least six edges from a boundary and the target's ball whole; without the half per
/// cent of the largest |t|. \throw std::runtime_error where a scan cannot be read
void print_cross_scan_scores(const std::string& folder);

}  // namespace accuracy
