// SPDX-License-Identifier: GPL-3.0-or-later
// How far a choice of scales could get with the truth in hand.
#pragma once

#include "cells.h"

namespace accuracy {

/// One line: mean error of κ, as in Metrics, where each vertex takes what is best, by the truth, for all vertices
/// within 16 ē: one scale or the convex combination of two neighbouring ones (least mean error of κ), and the weights
/// of all scales, of any sign and of sum 1 (least squares; mean curvature and deviator have their own). Candidates are
/// the balls at the default's radii without their own bias, and the fit to the nearest vertices. Minutes on large
/// meshes.
void print_oracle(const Cell& cell, const TruthMesh& truth, const TriangleMesh& noisy);
void print_oracle_header();

}  // namespace accuracy
