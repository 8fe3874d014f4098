// SPDX-License-Identifier: GPL-3.0-or-later
// The modes that go through the cells of cells.h: one table in CSV each, on the standard output.
#pragma once

#include <string>
#include <vector>

namespace accuracy {

/// accuracy peers|ours|cost [--models FOLDER] [--cells TEXT] [--part I/N] > table.csv
///
/// peers: each other estimator at each radius of its sweep, one line each. ours: compute_curvature() with its defaults,
/// one line a cell, judged at the same vertices of the same noisy meshes. cost: processor time of the default settings,
/// of the published ones, and of those with the default's radii. \throw std::invalid_argument
void run_cells(const std::vector<std::string>& arguments);

}  // namespace accuracy
