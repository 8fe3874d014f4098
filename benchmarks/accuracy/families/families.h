// SPDX-License-Identifier: GPL-3.0-or-later
// Families of cells: kinds of noise and meshing that real pipelines make, each on several shapes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "families/exact_shape.h"
#include "families/shape_catalogue.h"

namespace accuracy {

struct FamilyCell {
  std::string family;
  ExactShape shape;
  double level = 0;  ///< noise level, in average edges unless families.cpp says otherwise
  std::uint32_t seed = 0;
  /// Makes the mesh that the methods get, with its truth.
  std::function<TruthMesh(const FamilyCell&)> make;

  std::string name() const { return family + '/' + shape.name; }
};

/// Every family on each of its shapes; the same seed gives the same cells.
/// \param models folder of the CAD models with exact curvature, which the tuning half uses in its families of weak
/// noise; empty: without them
std::vector<FamilyCell> draw_cells(Half half, std::uint32_t seed, const std::string& models);

/// White noise of 0.05 to 1 ē on meshes of 41,000 vertices, and two shapes of some other families: the cells for
/// slower estimators.
std::vector<FamilyCell> draw_peer_cells(std::uint32_t seed);

}  // namespace accuracy
