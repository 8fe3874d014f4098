// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: what a filter is.
#pragma once

#include <vector>

#include "filter_result.h"
#include "integral_invariant/support/execution.h"
#include "integral_invariant/mesh/surface.h"
#include "parameter.h"

namespace integral_invariant::filter {

/// Places in the host's menu; a filter stands in all that are set.
enum Menu : unsigned {
  menu_selection = 1,
  menu_layers = 2,
  menu_quality = 4,
  menu_normals_and_curvature = 8,
  menu_vertex_colors = 16,
};

/// What a filter reads.
struct FilterInput {
  const TriangleMesh& mesh;
  const Request& request;
};

/// A filter whole: what people, scripts and hosts see of it, and what it does. Each has a file in filters/ and a line
/// in registry.def; everything else reads it from here.
struct Filter {
  const char* name;                       ///< in menus and filter scripts
  const char* python_name;                ///< in PyMeshLab
  const char* help;                       ///< simple HTML
  unsigned menus;                         ///< of Menu
  unsigned writes;                        ///< fields of the current mesh that it may write, of MeshField
  std::vector<ParameterSpec> parameters;  ///< in the order of the dialog

  /// Reads only; what is in the result is written by the host. The order of vertices, faces and corners within a face
  /// changes nothing but the order of what belongs to the vertices (see make_canonical_mesh()).
  /// \throw InputError and its kinds with a sentence for the user; Cancelled
  FilterResult (*run)(const FilterInput& input, const ProgressCallback& progress);
};

}  // namespace integral_invariant::filter
