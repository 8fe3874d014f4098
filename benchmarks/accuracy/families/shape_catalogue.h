// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes of the families, of size 1 and random proportions.
#pragma once

#include <random>
#include <vector>

#include "families/exact_shape.h"

namespace accuracy {

/// The shapes to develop with, or those that only the report uses.
enum class Half { tuning, report };

std::vector<ExactShape> draw_shapes(Half half, std::mt19937& generator);

/// Evenly spread bumps and hollows of height `height` · width: an open patch and a closed surface, where one bump is
/// `edges` average edges of a mesh of `vertices` vertices across.
std::vector<ExactShape> textured_shapes(double edges, int vertices, std::mt19937& generator);

}  // namespace accuracy
