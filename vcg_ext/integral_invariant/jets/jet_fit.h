// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: curvature tensor of a vertex from the vertices around it, which lie on the surface where flat triangles do
// not.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "integral_invariant/ball_curvature/tensor_field.h"
#include "integral_invariant/jets/height_polynomial.h"
#include "integral_invariant/mesh/surface.h"
#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// What a polynomial through the vertices around a vertex says. The variances are those under independent noise along
/// the normal of variance 1: of H, of either component of K − H I, of either tangential component of the normal.
struct Jet {
  CurvatureTensor tensor;  ///< confidence 1, or 0 where there were too few vertices
  double mean_variance = 0, deviator_variance = 0, normal_variance = 0;
  double support_radius = 0;      ///< distance of the farthest vertex that counted, L
  double residual_variance = -1;  ///< σ² of the noise, from distances to the polynomial, L²; −1: too few vertices
  double top_degree_variance = -1;  ///< what σ² would be if the terms of the highest degree were noise, L²
  double centroid_offset =
      0;  ///< distance of a disc's mean vertex from its centre, over its radius: 0.42 for a half disc
};

/// Standard error of its curvature, by its own residual; infinite where it has none.
double standard_error(const Jet& fit);

/// Fits around one vertex after the other; holds scratch memory, so one a thread. Neighbours are found along the edges:
/// other sheets of the surface do not count, and a boundary is nothing special.
class JetFitter {
 public:
  /// \param barrier n flags, or nothing: vertices that discs neither count nor cross.
  explicit JetFitter(const Surface& surface, const std::vector<char>& barrier = {});

  /// A polynomial of degree 4 through the nearest 20 vertices, the nearer the heavier; of lower degree where they are
  /// few.
  /// \param normal roughly the surface's normal at v. Cost about 3 µs.
  Jet nearest(std::size_t v, const Vec3& normal);
  /// For vertices without noise, the polynomial that promises the smallest error: `usual`, which is nearest() of the
  /// same vertex, or one of degree 4 or 6 whose nearest 18 or 36 vertices weigh less the farther they are. Where even
  /// that error is more than a hundredth of the curvature, because the curvature jumps, one through the vertices of one
  /// side alone, if it promises much less and the other side has the same normal: a crease is not taken apart. Cost
  /// about 10 µs, 40 where sides are tried.
  Jet finest(std::size_t v, const Jet& usual);

  /// Begins a disc about v, across `normal`, which extend_disc() then lets grow.
  void begin_disc(std::size_t v, const Vec3& normal);
  /// Quadric through all vertices that edges lead to within `radius` in the tangent plane and twice that in height; not
  /// under the radius before. None where these are more than 1536, and then for all larger radii. Over a whole disc the
  /// same as offset_free_measure(), to first order. Cost O(r²) in all, about 15 µs up to r = 16 ē.
  Jet extend_disc(double radius);
  /// Of (H, (K_uu − K_vv)/2, K_uv) of the disc that was grown last, under independent noise of variance 1, where u is
  /// along `axis` as far as that is in the disc's plane, and v is normal × u.
  Symmetric3 disc_covariance(const Vec3& axis) const;

 private:
  struct Place {
    double squared_distance, x, y, height;
    std::uint32_t vertex;
  };
  Place place_of(std::uint32_t u, const Vec3& centre, const HeightFrame& frame) const;
  void start_at(std::size_t v);
  struct JetKind {
    int degree;
    std::size_t count;        ///< of vertices
    std::size_t least_count;  ///< if there are fewer in two rings, more rings are walked
    double weight_fall;       ///< the farthest vertex weighs exp(−weight_fall)
  };
  Jet fit_k_nearest(std::size_t v, const Vec3& normal, const JetKind& kind);
  Jet fit_one_side(std::size_t v, const Jet& of_all_sides);
  Jet fit_places(const HeightFrame& frame, const JetKind& kind);
  void walk_rings(std::size_t v, const HeightFrame& frame, std::size_t least_count);
  std::size_t find_unseen(std::uint32_t begin, std::uint32_t end, std::uint32_t* unseen);
  void take_into_disc(const Place& place);

  const Surface& surface_;
  const std::vector<char>* barrier_;  ///< or null
  std::uint32_t stamp_ = 0;
  std::vector<std::uint32_t> seen_, queue_;
  std::vector<Place> places_;
  HeightPlaces heights_in_lanes_;
  // The disc: heights over a frame at its centre, the vertices that wait beyond its rim.
  HeightFrame frame_{{0, 0, 1}};
  Symmetric3 disc_covariance_;  ///< as seen from the frame
  Vec3 centre_;
  HeightSums sums_;
  PlaceColumns taken_;  ///< vertices that are not yet in the sums
  std::vector<Place> beyond_;
};

/// A fitter for each worker, made when it is first asked for: its marks are as long as the mesh.
class JetFitters {
 public:
  JetFitters(const Surface& surface, const Execution& execution, const std::vector<char>& barrier = no_barrier())
      : surface_(surface), barrier_(barrier), fitters_(std::size_t(execution.threads()))
  {
  }
  JetFitter& of(int worker)
  {
    std::unique_ptr<JetFitter>& fitter = fitters_[std::size_t(worker)];
    if (!fitter) fitter = std::make_unique<JetFitter>(surface_, barrier_);
    return *fitter;
  }

 private:
  static const std::vector<char>& no_barrier()
  {
    static const std::vector<char> none;
    return none;
  }

  const Surface& surface_;
  const std::vector<char>& barrier_;
  std::vector<std::unique_ptr<JetFitter>> fitters_;
};

/// Normals of the vertices' patches: of the summed area vectors of the triangles of a vertex and of its neighbours,
/// which depend on the patch's rim alone, not on the noise inside, and know no other sheet. Cost O(n).
std::vector<Vec3> patch_normals(const Surface& surface, Execution& execution);

/// Normal of the ball of the fourth scale (not the prey of noise), or of the largest under it in which the surface is
/// nearly a plane; `patch`, where that ball turns away from it because it sees another sheet or a crease.
Vec3 rough_normal(const TensorField& tensors, std::size_t v, const Vec3& patch);

/// JetFitter::nearest() at all vertices, about their rough normals.
std::vector<Jet> fit_jets(const Surface& surface, const TensorField& tensors, Execution& execution);

}  // namespace integral_invariant
