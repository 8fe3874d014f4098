// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: what the filters for features leave, complete before a mesh is touched.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "integral_invariant/support/execution.h"
#include "outcome.h"
#include "parameter_table.h"
#include "quality.h"

namespace integral_invariant::filter {

/// Lines that become a layer of edges. One entry a vertex of the lines.
struct LineLayer {
  std::string label;
  std::vector<Vec3> positions;  ///< in the caller's unit
  std::vector<Vec3> normals;    ///< of the surface there
  std::vector<std::array<std::int32_t, 2>> edges;
  std::vector<double> quality;
  std::vector<Color> colors;  ///< empty: not coloured
  std::vector<NamedValues> attributes;
};

/// What is empty leaves the mesh as it is.
struct FeatureOutcome {
  std::vector<std::int32_t> selection;  ///< region of every vertex, -1: not selected
  std::vector<double> quality;
  std::vector<Color> colors;
  std::vector<NamedValues> attributes;
  std::optional<LineLayer> lines;
  std::vector<std::string> log;                              ///< one line an entry
  std::vector<std::pair<std::string, SummaryValue>> values;  ///< the same for programs
  std::string exported;                                      ///< the file that was written; empty: none
};

/// Runs one of the filters other than FilterId::curvature. The order of vertices, faces and corners within a face
/// changes nothing but the order of what belongs to the vertices (see make_canonical_mesh()). \throw InputError and its
/// kinds, Cancelled
FeatureOutcome compute_feature(FilterId filter, const TriangleMesh& mesh, const Request& request,
                               const ProgressCallback& progress);

}  // namespace integral_invariant::filter
