// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the mesh with every output of a filter as a property of its vertices, or the lines of a filter as edges. Not
// through VCG's exporter, which notices neither a full disk nor a failed close, and knows one precision for all
// coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "filter_result.h"
#include "integral_invariant/mesh/surface.h"
#include "ply_writer.h"

namespace integral_invariant::filter {

/// What the user's mesh has beside its shape: rows in the order of its vertices and faces.
struct MeshExtras {
  std::vector<PlyProperty> vertex, face;
  std::vector<std::string> comments;
};

/// What goes into a file beside the mesh; empty: nothing of that kind. Entries a vertex in its order.
struct PlyContents {
  std::vector<std::array<std::int32_t, 2>> edges;
  std::vector<double> quality;
  std::vector<Color> colors;
  std::vector<NamedValues> properties;
  MeshExtras extras;
};

/// Binary PLY of the mesh (which may have no triangles) with those contents. The file appears whole or not at all: a
/// failure leaves an older one as it was. \return the absolute path. \throw InputError where it cannot be written
std::string export_ply(const TriangleMesh& mesh, const PlyContents& contents, const std::string& path);

/// The same of a run. Lines: x y z, red green blue alpha (where they are coloured), quality, their attributes, edges.
/// Otherwise the mesh with colour, quality and attributes, and, where there are curvatures, ii_kmax, ii_kmin,
/// ii_radius, ii_confidence, ii_error, ii_dirmax_x _y _z, ii_dirmin_x _y _z; faces as they are. Each scalar attribute
/// is there as scalar_ii_kmax etc. too, and the extras as they are, as original_red etc. where a result takes the name.
std::string export_ply(const TriangleMesh& mesh, const FilterResult& result, const std::string& path,
                       const MeshExtras& extras = {});

/// Writes these bytes as they are. \return the absolute path. \throw InputError where the file cannot be written
std::string export_bytes(const std::string& bytes, const std::string& path);

/// \throw InputError unless a file can be made in the folder of `path`: tells the user before the long computation
void require_writable(const std::string& path);

}  // namespace integral_invariant::filter
