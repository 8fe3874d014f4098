// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "integral_invariant/mesh.h"
#include "integral_invariant/support/axes.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

struct Edge;

/// What was found on checking a mesh. Counts only: nothing is repaired, deleted or renumbered.
struct SurfaceReport {
  std::size_t vertices = 0, triangles = 0;
  std::size_t joined_vertices = 0;  ///< copies of another vertex at the same place: they have its results
  std::size_t unreferenced_vertices = 0;
  std::size_t nonfinite_vertices = 0;   ///< a coordinate is NaN or infinite
  std::size_t left_out_triangles = 0;   ///< a vertex is used twice or is not finite
  std::size_t zero_area_triangles = 0;  ///< kept: they may be what closes the surface
  std::size_t duplicate_triangles = 0;  ///< same three vertices in the same cyclic order as another
  std::size_t boundary_edges = 0;       ///< edges with a triangle on one side only
  std::size_t inconsistent_edges = 0;   ///< edges that their triangles do not pass equally often in both directions
  double coordinate_step = 0;           ///< L; between neighbouring values of the largest coordinates
  bool inside_out = false;              ///< encloses a negative volume: taken as if all triangles were flipped
};

/// A checked mesh in normalised coordinates: the average edge length is 1 and the bounding box is centred at 0, so that
/// the stages need no tolerance that depends on the unit of the mesh.
class Surface {
 public:
  /// Cost O(n + m). \throw InputError without triangles of positive area, or where an index is out of range.
  Surface(const TriangleMesh& mesh, Execution& execution);
  /// The same with one thread.
  explicit Surface(const TriangleMesh& mesh);

  /// Takes coordinates along `axes` from now on, about the centre of the box along them. What was found on checking the
  /// mesh stays as it was. Cost O(n).
  void turn_to(const Axes& axes, Execution& execution);

  std::size_t vertex_count() const { return positions_.size(); }
  /// n; vertices without a triangle stand at the origin.
  const std::vector<Vec3>& positions() const { return positions_; }
  /// The triangles that bound the solid: those of the mesh without the left-out ones and without repetitions of a
  /// triangle (unless the repetitions are what closes the surface), flipped if the mesh was inside out.
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// Whether a triangle of triangles() uses the vertex.
  bool is_referenced(std::size_t vertex) const { return neighbour_start_[vertex] != neighbour_start_[vertex + 1]; }

  /// Neighbours of v along edges: neighbours()[neighbour_start()[v]] up to neighbour_start()[v + 1], each once,
  /// increasing.
  const std::vector<std::uint32_t>& neighbour_start() const { return neighbour_start_; }
  const std::vector<std::uint32_t>& neighbours() const { return neighbours_; }

  /// Length of the normalised unit in the caller's unit: the average edge length ē.
  double unit() const { return unit_; }
  /// Diagonal of the mesh's bounding box, in normalised coordinates.
  double diagonal() const { return diagonal_; }
  /// Every edge is passed equally often in both directions.
  bool is_closed() const { return report_.boundary_edges == 0 && report_.inconsistent_edges == 0; }
  const SurfaceReport& report() const { return report_; }

 private:
  void take_triangles(const TriangleMesh& mesh, Execution& execution);
  void normalise(const TriangleMesh& mesh, const std::vector<Edge>& edges, Execution& execution);
  void require_shape(const TriangleMesh& mesh, const std::vector<char>& used, Execution& execution);
  void drop_repetitions(std::vector<Edge>& edges, Execution& execution);
  void connect(const std::vector<Edge>& edges, Execution& execution);
  void turn_outward(Execution& execution);

  std::vector<Vec3> positions_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> neighbour_start_, neighbours_;
  double unit_ = 1, diagonal_ = 0;
  SurfaceReport report_;
};

}  // namespace integral_invariant
