// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: everything that a run of a filter leaves, complete before a mesh is touched.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "integral_invariant/result.h"
#include "quality.h"

namespace integral_invariant::filter {

/// One number a vertex under the name that hosts and files know it by.
struct NamedValues {
  std::string name;
  std::vector<float> values;
};

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

/// A line of the summary for programs.
using SummaryValue = std::variant<int, double, std::string>;

/// What is empty leaves the mesh as it is. Arrays have one entry a vertex, in the order of the mesh.
struct FilterResult {
  std::optional<Result> curvature;      ///< becomes the mesh's curvatures, directions, radii and the attributes of them
  std::vector<std::int32_t> selection;  ///< region of every vertex, -1: not selected
  std::vector<double> quality;
  std::vector<Color> colors;
  std::vector<NamedValues> attributes;
  std::optional<LineLayer> lines;
  std::string file;  ///< what export_file is to hold; empty: the mesh, or the lines, as PLY

  std::vector<std::string> log;                              ///< one line an entry
  std::vector<std::pair<std::string, SummaryValue>> values;  ///< the same for programs
};

/// Fields of a mesh, as hosts have to be told which ones a filter writes.
enum MeshField : unsigned {
  field_curvature = 1,  ///< principal curvatures and directions
  field_radius = 2,
  field_quality = 4,
  field_color = 8,
  field_selection = 16,
};

/// The fields of MeshField that the result has something for.
unsigned written_fields(const FilterResult& result);

}  // namespace integral_invariant::filter
