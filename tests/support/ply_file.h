// SPDX-License-Identifier: GPL-3.0-or-later
// PLY files without VCG, so that what VCG wrote is read by other code.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "integral_invariant/mesh/surface.h"

namespace test_support {

using integral_invariant::Triangle;
using integral_invariant::TriangleMesh;
using integral_invariant::Vec3;

/// Vertex properties by name, each with one value a vertex, the faces, cut into triangles, and the edges.
struct PlyFile {
  std::map<std::string, std::vector<double>> vertex;
  std::vector<Triangle> triangles;
  std::vector<std::array<std::int32_t, 2>> edges;

  /// \throw std::runtime_error with the names that there are
  const std::vector<double>& property(const std::string& name) const;
  /// The properties name_x, name_y, name_z.
  std::vector<Vec3> vectors(const std::string& name) const;
  TriangleMesh mesh() const;
};

/// Ascii or binary little endian. \throw std::runtime_error
PlyFile read_ply(const std::string& path);

/// Binary, coordinates in single precision; `extra` are further vertex properties of type float.
void write_ply(const std::string& path, const TriangleMesh& mesh,
               const std::map<std::string, std::vector<double>>& extra = {});

/// The mesh as a host with single precision has it.
TriangleMesh in_single_precision(TriangleMesh mesh);

}  // namespace test_support
