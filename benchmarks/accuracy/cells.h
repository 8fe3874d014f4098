// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of the benchmark: shape × meshing × noise.
#pragma once

#include <string>
#include <vector>

#include "truth.h"

namespace accuracy {

struct Cell {
  std::string shape, meshing;  ///< meshing "cad": a model with curvatures from its CAD surface
  double sigma;                ///< noise over the average edge length

  std::string name() const;
  std::uint32_t seed() const;  ///< of its noise
};

/// All cells; those of one mesh follow one another. `models` is the folder of the CAD models; empty: without them.
std::vector<Cell> all_cells(const std::string& models);

/// The mesh of a cell without its noise.
TruthMesh load(const Cell& cell, const std::string& models);

}  // namespace accuracy
