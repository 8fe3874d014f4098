// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1: ball moments as exact sums over the triangles of the surface.
#include "integral_invariant/moments/surface/surface_engine.h"

#include <algorithm>

#include "integral_invariant/moments/surface/ball_evaluator.h"
#include "integral_invariant/moments/surface/far_field.h"
#include "integral_invariant/moments/surface/interaction_culling.h"
#include "integral_invariant/moments/surface/interaction_list.h"
#include "integral_invariant/support/memory.h"

namespace integral_invariant {

namespace {

/// Longest edge, in radii, up to which a triangle's circular segments are left out (measured: docs/surface_engine.md).
double small_edge(Exactness exactness)
{
  switch (exactness) {
    case Exactness::exact:
      return 0;
    case Exactness::balanced:
      return 1.5;
    case Exactness::fast:
      return 3;
  }
  return 0;
}

class SurfaceEngine : public MomentEngine {
 public:
  SurfaceEngine(const Surface& surface, const Parameters& parameters, Execution& execution)
      : parameters_(parameters), tree_(surface, parameters.exactness != Exactness::exact, execution)
  {
    split_into_blocks(execution);
  }

  void evaluate(const std::vector<double>& radii, const MomentSink& sink, Execution& execution) const override
  {
    const bool has_far = parameters_.exactness != Exactness::exact && !parameters_.same_sheet;
    const ScaleSplit split = has_far ? ScaleSplit::of(radii) : ScaleSplit::none(radii);
    std::vector<std::unique_ptr<Worker>> workers(std::size_t(execution.threads()));
    parallel_for(blocks_.size() - 1, 4, execution, [&](std::size_t begin, std::size_t end, int worker) {
      std::unique_ptr<Worker>& w = workers[std::size_t(worker)];
      if (!w) w.reset(new Worker(tree_, radii, split, far_detail(), parameters_));
      for (std::size_t block = begin; block < end; ++block)
        evaluate_block(blocks_[block], blocks_[block + 1], *w, sink);
    });
  }

  std::string description(const std::vector<double>&, Execution&) const override
  {
    return "surface integral over " + std::to_string(tree_.order().triangles.size()) + " triangles, " +
           std::to_string(tree_.order().boundary_edges.size()) + " boundary edges";
  }

 private:
  /// What compares scales takes the quadrature's error for noise or bias, where there is little of these: measured by
  /// benchmarks/accuracy.
  FarDetail far_detail() const
  {
    const bool compares_scales =
        parameters_.radius_choice == RadiusChoice::statistical || parameters_.estimator == Estimator::bias_free;
    return compares_scales ? FarDetail{4.5, 12} : FarDetail{3.9, 4.5};
  }

  /// The scratch memory of closed forms.
  struct ClosedForms {
    ClosedForms(const SurfaceTree& tree, const std::vector<double>& radii, double reach, const Parameters& parameters,
                LastRadius last_radius)
        : gatherer(tree, radii, reach, small_edge(parameters.exactness), !parameters.same_sheet),
          vicinity(tree, radii, !parameters.same_sheet),
          evaluator(radii, parameters.same_sheet, last_radius)
    {
    }
    InteractionGatherer gatherer;
    CulledInteractions vicinity;
    BallEvaluator evaluator;
  };

  /// Of one thread. Blocks whose triangles are too large for points beyond a rim take the closed forms throughout.
  struct Worker {
    Worker(const SurfaceTree& tree, const std::vector<double>& radii, const ScaleSplit& split, const FarDetail& detail,
           const Parameters& parameters)
        : all(tree, radii, radii.back(), parameters, LastRadius::ball)
    {
      if (split.far.empty()) return;
      near = std::make_unique<ClosedForms>(tree, split.near, radii.back(), parameters, LastRadius::rim);
      far = std::make_unique<FarField>(tree, split, detail);
    }
    ClosedForms all;
    std::unique_ptr<ClosedForms> near;
    std::unique_ptr<FarField> far;
  };

  /// Runs of points along the curve that stay together: what one ball of the block touches, the others touch too.
  void split_into_blocks(Execution& execution)
  {
    constexpr std::size_t largest_block = 128;
    constexpr double largest_extent = 15;  // edges
    const std::vector<Vec3>& points = tree_.order().points;
    Vec3 low, high;
    for_each_in_order(points.size(), execution, [&](std::size_t i) {
      const Vec3& p = points[i];
      const Vec3 l{std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      const Vec3 h{std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      if (i == 0 || i - blocks_.back() == largest_block || squared_norm(h - l) > largest_extent * largest_extent) {
        blocks_.push_back(i);
        low = high = p;
      } else {
        low = l;
        high = h;
      }
    });
    blocks_.push_back(points.size());
  }

  void evaluate_block(std::size_t begin, std::size_t end, Worker& worker, const MomentSink& sink) const
  {
    if (worker.near) {
      const InteractionList& near = worker.near->gatherer.gather(begin, end);
      if (near.longest_edge <= longest_near_edge) {
        worker.far->enter(near);
        evaluate_points(begin, end, near, *worker.near, worker.far.get(), sink);
        return;
      }
    }
    evaluate_points(begin, end, worker.all.gatherer.gather(begin, end), worker.all, nullptr, sink);
  }

  void evaluate_points(std::size_t begin, std::size_t end, const InteractionList& near, ClosedForms& forms,
                       FarField* far, const MomentSink& sink) const
  {
    constexpr std::size_t close = 8;  // points: about two edges across
    const PreparedMesh& order = tree_.order();
    forms.vicinity.enter(near);
    std::size_t measured = end;  // the last one
    for (std::size_t point = begin; point < end; ++point) {
      const std::uint32_t local = std::uint32_t(point - begin);
      const bool is_border = tree_.is_border(std::uint32_t(point));
      if (local % close == 0) {
        const std::uint32_t last = std::uint32_t(std::min(point + close, end) - begin);
        forms.vicinity.narrow(local, last);
        if (far) far->narrow(local, last);
      }
      if (!may_share(measured, point, near, forms.vicinity)) {
        const auto& moments = forms.evaluator.evaluate(near, forms.vicinity, local, order.normals[point], is_border);
        if (far) far->evaluate(forms.evaluator, local, moments.back(), is_border);
        measured = point;
      }
      const auto& moments = forms.evaluator.moments();
      hand_over(point, 0, moments.data(), far ? moments.size() - 1 : moments.size(), sink);
      if (far) hand_over(point, moments.size() - 1, far->moments().data(), far->moments().size(), sink);
    }
  }

  /// Whether the moments about point `measured` may serve `point` too: among triangles that are no surface, where balls
  /// cut so many of them that a measure of each point's own would cost their square.
  bool may_share(std::size_t measured, std::size_t point, const InteractionList& near,
                 const CulledInteractions& vicinity) const
  {
    constexpr std::size_t leaves_a_measure = 32;
    constexpr double largest_shift = 0.75;  // edges: half of the smallest radius of the default
    if (!near.is_crowd || measured >= point || point - measured > vicinity.close_leaf_count() / leaves_a_measure)
      return false;
    const std::vector<Vec3>& points = tree_.order().points;
    return squared_norm(points[point] - points[measured]) < largest_shift * largest_shift;
  }

  /// To all vertices at the point, from scale `first` on.
  void hand_over(std::size_t point, std::size_t first, const BallMoments* moments, std::size_t count,
                 const MomentSink& sink) const
  {
    const PreparedMesh& order = tree_.order();
    for (std::uint32_t i = order.vertex_start[point]; i < order.vertex_start[point + 1]; ++i)
      for (std::size_t k = 0; k < count; ++k) sink(order.vertices[i], int(first + k), moments[k]);
  }

  const Parameters parameters_;
  const SurfaceTree tree_;
  std::vector<std::size_t> blocks_;
};

}  // namespace

std::unique_ptr<MomentEngine> make_surface_engine(const Surface& surface, const Parameters& parameters,
                                                  Execution& execution)
{
  // Measured: places, order, hierarchy with its moments, and the lists that sorting needs meanwhile.
  constexpr double bytes_per_vertex = 140, bytes_per_triangle = 60;
  require_memory(
      bytes_per_vertex * double(surface.vertex_count()) + bytes_per_triangle * double(surface.triangles().size()),
      parameters.memory_limit_mb, "The surface engine for " + std::to_string(surface.triangles().size()) + " triangles",
      "Reduce the number of triangles");
  return std::make_unique<SurfaceEngine>(surface, parameters, execution);
}

}  // namespace integral_invariant
