// SPDX-License-Identifier: GPL-3.0-or-later
// Other estimators on the families, each at its best radius up to 40 ē.
#pragma once

namespace accuracy {

/// accuracy family_peers [--seed N] [--cells TEXT] > table.csv
///
/// One line a cell and estimator: the least mean errors of κ and of directions over all radii, and ours, at 100
/// vertices of the white-noise cells (σ = 0.05, 0.1, 0.2, 0.5, 1 ē, on meshes of 25,000 vertices) and of a sample of
/// the other families, all of the tuning half. \throw std::invalid_argument
void run_family_peers(int argc, char** argv);

}  // namespace accuracy
