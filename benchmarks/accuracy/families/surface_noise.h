// SPDX-License-Identifier: GPL-3.0-or-later
// Noise of many kinds on a mesh whose exact normals are known.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "integral_invariant/mesh.h"

namespace accuracy {

using integral_invariant::TriangleMesh;
using integral_invariant::Vec3;

/// A mesh on its exact surface, which the functions below move.
struct NoisyMesh {
  TriangleMesh mesh;
  std::vector<Vec3> normal;  ///< of the exact surface
  double edge = 0;           ///< average, at the beginning
  std::mt19937* generator = nullptr;
};

// Along the normals; levels and lengths in average edges.
void add_white(NoisyMesh& m, double level);
/// Gaussian correlation exp(−d²/(2 length²)) over the distance d in space.
void add_correlated(NoisyMesh& m, double level, double length);
/// Independent, its level growing by the factor `range` from one end of the mesh to the other, geometrically.
void add_varying(NoisyMesh& m, double least_level, double range);
/// Moves the share `share` of the vertices by `height`, in or out.
void add_spikes(NoisyMesh& m, double share, double height);

/// Independent in all three coordinates.
void add_jitter(NoisyMesh& m, double level);
/// One height for each line of vertices with the same y.
void add_line_offsets(NoisyMesh& m, double level);

/// Rounds all coordinates to whole steps; heights alone: those along z.
void round_coordinates(TriangleMesh& mesh, double step);
void round_heights(TriangleMesh& mesh, double step);

}  // namespace accuracy
