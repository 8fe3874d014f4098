// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes whose curvatures and directions are known at every vertex: what the benchmark measures against.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "integral_invariant/mesh/surface.h"

namespace accuracy {

using integral_invariant::Triangle;
using integral_invariant::TriangleMesh;
using integral_invariant::Vec3;

struct TruthMesh {
  TriangleMesh mesh;
  std::vector<Vec3> normal;                  ///< of the smooth surface, outward
  std::vector<double> kappa_max, kappa_min;  ///< 1/L, positive where the solid is convex
  std::vector<Vec3> dir_max;
  std::vector<double> reference;      ///< 1/L: root mean square κ that errors at the vertex are relative to
  std::vector<std::uint32_t> known;   ///< the vertices whose truth is known
  std::vector<std::uint32_t> judged;  ///< those of them that methods are judged at
};

/// Fills `reference` of vertices [begin, end) with the root mean square of their κ.
void set_reference(TruthMesh& truth, std::size_t begin, std::size_t end);

/// The truth of the vertices `known` is known; judges at `count` of them, drawn without repetition, always the same.
void draw_judged(TruthMesh& truth, std::vector<std::uint32_t> known, std::size_t count);

/// Moves every vertex along the true normal by Gaussian noise of standard deviation `sigma` times the average edge.
TriangleMesh with_noise(const TruthMesh& truth, double sigma, std::uint32_t seed);

}  // namespace accuracy
