// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: what of a block's neighbourhood the spheres about few of its points, and about one of them, can cut.
#pragma once

#include <cstdint>
#include <vector>

#include "integral_invariant/moments/surface/interaction_list.h"

namespace integral_invariant {

/// Narrows a neighbourhood down in two steps. What lies between the same two spheres for all of the points in question
/// is left out and its moments are summed; all moments are about the neighbourhood's centre, so that sums of the first
/// step serve the second one as they are.
class CulledInteractions {
 public:
  /// `sum_far` as for the gatherer: without it, leaves are left out only where they are beyond the largest radius.
  CulledInteractions(const SurfaceTree& tree, const std::vector<double>& radii, bool sum_far);

  /// To another neighbourhood.
  void enter(const InteractionList& near);
  /// To the local points [begin, end), which should lie close together.
  void narrow(std::uint32_t begin, std::uint32_t end);
  /// To one of them: writes its leaves and the first scale of every local point.
  void centre_on(std::uint32_t point, std::vector<std::uint8_t>& scale_of);

  /// Leaves that spheres about the point may cut.
  const std::vector<std::uint32_t>& leaves() const { return leaves_; }
  /// Triangles that a sphere about the narrowed points, against which they are large, may cut.
  const std::vector<std::uint32_t>& large() const { return close_large_; }
  /// Leaves that spheres about the narrowed points may cut.
  std::size_t close_leaf_count() const { return close_leaves_.size(); }
  bool has_far(std::size_t scale) const { return far_.has[scale]; }
  /// Of what is inside from the scale on and not in leaves(); about the neighbourhood's centre.
  const SurfaceMultipoles& far(std::size_t scale) const { return far_.moments[scale]; }

 private:
  struct Far {
    std::vector<SurfaceMultipoles> moments;
    std::vector<char> has;
  };

  void add_far(std::uint32_t leaf, std::uint8_t scale, Far& far);
  void sort_points(const Sphere& around);
  void choose_large(const Sphere& around);

  const SurfaceTree& tree_;
  const std::vector<double>& radii_;
  std::vector<double> squared_radii_;
  const bool sum_far_;
  const InteractionList* near_ = nullptr;
  std::vector<SurfaceMultipoles> leaf_moments_;  ///< per leaf of the neighbourhood, where asked for before
  std::vector<char> has_leaf_moments_;
  std::vector<std::uint8_t> least_, largest_;
  std::vector<std::uint32_t> close_leaves_, leaves_, close_large_;
  SphereColumns close_spheres_;
  Far close_far_, far_;
  std::vector<std::uint8_t> common_scale_;  ///< per point, for the groups that no sphere cuts
  std::vector<std::uint32_t> cut_groups_;
};

}  // namespace integral_invariant
