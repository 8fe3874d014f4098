// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1, FFT engine: per radius a grid, per tile of it one forward transform of the solid, ten products with kernels
// and ten inverse transforms, read at the tile's vertices.
#include "integral_invariant/moments/fft_engine.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <mutex>
#include <sstream>

#include "integral_invariant/moments/ball_kernel.h"
#include "integral_invariant/moments/decimation.h"
#include "integral_invariant/moments/fftw_plan.h"
#include "integral_invariant/moments/grid_interpolation.h"
#include "integral_invariant/moments/scan_conversion.h"
#include "integral_invariant/moments/tile_layout.h"
#include "integral_invariant/support/error.h"
#include "integral_invariant/support/memory.h"

namespace integral_invariant {

namespace {

/// Cells along x that are scan-converted in one go; fixed, so that rounding does not depend on the threads.
constexpr int slab_width = 16;

/// A tile in work: its transform and what is read at its vertices.
struct Workspace {
  explicit Workspace(const std::array<int, 3>& size) : transform(size), product(size) {}
  FftBuffer transform, product;
  std::vector<float> values;  ///< moment_count per vertex of the tile
};

/// As many workspaces as memory allows; whoever needs one waits for it.
class WorkspacePool {
 public:
  WorkspacePool(const std::array<int, 3>& size, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i) {
      all_.push_back(std::make_unique<Workspace>(size));
      free_.push_back(all_.back().get());
    }
  }

  /// Calls `use` with a workspace that no other thread has.
  template <class Use>
  void lend(const Use& use)
  {
    Workspace* workspace = take();
    try {
      use(*workspace);
    } catch (...) {
      give(workspace);
      throw;
    }
    give(workspace);
  }

 private:
  Workspace* take()
  {
    std::unique_lock lock(mutex_);
    freed_.wait(lock, [this] { return !free_.empty(); });
    Workspace* workspace = free_.back();
    free_.pop_back();
    return workspace;
  }
  void give(Workspace* workspace)
  {
    const std::lock_guard lock(mutex_);
    free_.push_back(workspace);
    freed_.notify_one();
  }

  std::vector<std::unique_ptr<Workspace>> all_;
  std::vector<Workspace*> free_;
  std::mutex mutex_;
  std::condition_variable freed_;
};

/// Everything about one radius that its tiles share.
class ScalePass {
 public:
  ScalePass(const Surface& surface, const TileLayout& layout, int scale, const MomentSink& sink)
      : surface_(surface), layout_(layout), fine_grid_{layout.grid.origin, layout.grid.step / 2}, scale_(scale), sink_(sink),
        transform_(layout.shape.size), kernel_(layout.shape.size, layout.radius_cells),
        triangles_(tile_triangles(surface, layout)),
        rows_(std::size_t(layout.shape.size[1])), row_stride_(FftBuffer::row_stride(layout.shape.size))
  {
  }

  void run(Execution& execution, std::size_t memory, double from, double to)
  {
    find_carries(execution, from, from);
    const std::size_t tiles = layout_.tiles.size(), threads = std::size_t(execution.threads());
    if (tiles < 2 * threads) {
      for (std::size_t tile = 0; tile < tiles; ++tile)
        run_tile_inside(tile, execution, from + (to - from) * double(tile) / double(tiles),
                        from + (to - from) * double(tile + 1) / double(tiles));
      return;
    }
    const std::size_t bytes = worker_bytes(layout_.shape);
    WorkspacePool pool(layout_.shape.size, std::clamp<std::size_t>(memory / bytes, 1, threads));
    parallel_for(tiles, 1, execution, [&](std::size_t begin, std::size_t end, int) {
      for (std::size_t tile = begin; tile < end; ++tile)
        pool.lend([&](Workspace& workspace) { run_tile(tile, workspace); });
    }, from, to);
  }

 private:
  /// The tile's box on the grid of half the step, with the cells around it that decimation reads.
  CellBox fine_box(std::size_t tile) const
  {
    CellBox box = layout_.box(tile);
    for (std::size_t a = 0; a < 3; ++a) {
      box.begin[a] = 2 * box.begin[a] - 1;
      box.size[a] = fine_size(box.size[a]);
    }
    return box;
  }
  std::size_t plane_size() const
  {
    return std::size_t(fine_size(layout_.shape.size[0])) * std::size_t(fine_size(layout_.shape.size[1]));
  }

  void find_carries(Execution& execution, double from, double to)
  {
    carries_.resize(layout_.tiles.size() * plane_size());
    const IndexLists triangles = stack_triangles(surface_, layout_);
    parallel_for(layout_.stack_count(), 1, execution, [&](std::size_t begin, std::size_t end, int) {
      for (std::size_t stack = begin; stack < end; ++stack) {
        const std::size_t first = layout_.stack_start[stack];
        std::vector<std::int64_t> tops;
        for (std::size_t tile = first; tile < layout_.stack_start[stack + 1]; ++tile)
          tops.push_back(fine_box(tile).begin[2] + fine_box(tile).size[2]);
        carry_planes(surface_, fine_grid_, fine_box(first), triangles.row(stack), tops,
                     carries_.data() + first * plane_size());
      }
    }, from, to);
  }

  std::size_t slab_count() const { return std::size_t((layout_.shape.size[0] + slab_width - 1) / slab_width); }

  void scan_slab(std::size_t tile, const std::vector<std::uint32_t>& triangles, std::size_t slab, FftBuffer& buffer) const
  {
    const int offset = int(slab) * slab_width;
    std::array<int, 3> size = layout_.shape.size;
    size[0] = std::min(slab_width, size[0] - offset);
    CellBox box = fine_box(tile);
    box.begin[0] += 2 * offset;
    box.size[0] = fine_size(size[0]);
    std::vector<float> fine(std::size_t(box.size[0]) * std::size_t(box.size[1]) * std::size_t(box.size[2]));
    scan_convert(surface_, fine_grid_, box, triangles,
                 carries_.data() + tile * plane_size() + 2 * std::size_t(offset) * std::size_t(box.size[1]), fine.data(),
                 std::size_t(box.size[2]));
    decimate(fine, size, buffer.reals() + std::size_t(offset) * rows_ * row_stride_, row_stride_);
  }

  /// One of the ten: product, inverse transform, values at the tile's vertices.
  void find_moment(std::size_t tile, int moment, const FftBuffer& transform, FftBuffer& product,
                   std::vector<float>& values) const
  {
    kernel_.apply(moment, transform.complexes(), product.complexes());
    transform_.inverse(product);
    const CellBox box = layout_.box(tile);
    const Vec3 corner{double(box.begin[0]), double(box.begin[1]), double(box.begin[2])};
    const IndexLists& lists = layout_.tile_vertices;
    const std::size_t first = lists.start[tile];
    for (std::size_t i = first; i < lists.start[tile + 1]; ++i) {
      const Vec3 position = layout_.grid.to_cells(surface_.positions()[lists.indices[i]]) - corner;
      const SplineWeights weights = spline_weights(position, rows_, row_stride_);
      values[(i - first) * moment_count + std::size_t(moment)] =
          float(spline_value(weights, product.reals(), rows_, row_stride_));
    }
  }

  void deliver(std::size_t tile, const std::vector<float>& values) const
  {
    const double h = layout_.grid.step, h3 = h * h * h, h4 = h3 * h, h5 = h4 * h;
    const IndexLists& lists = layout_.tile_vertices;
    const float* v = values.data();
    for (std::size_t i = lists.start[tile]; i < lists.start[tile + 1]; ++i, v += moment_count) {
      BallMoments moments;
      moments.volume = double(v[0]) * h3;
      moments.first = Vec3{double(v[1]), double(v[2]), double(v[3])} * h4;
      moments.second = Symmetric3{double(v[4]), double(v[5]), double(v[6]), double(v[7]), double(v[8]), double(v[9])} * h5;
      sink_(lists.indices[i], scale_, moments);
    }
  }

  std::size_t value_count(std::size_t tile) const
  {
    return (layout_.tile_vertices.start[tile + 1] - layout_.tile_vertices.start[tile]) * moment_count;
  }

  void run_tile(std::size_t tile, Workspace& workspace) const
  {
    const std::vector<std::uint32_t> triangles = triangles_.row(tile);
    for (std::size_t slab = 0; slab < slab_count(); ++slab) scan_slab(tile, triangles, slab, workspace.transform);
    transform_.forward(workspace.transform);
    workspace.values.resize(value_count(tile));
    for (int moment = 0; moment < moment_count; ++moment)
      find_moment(tile, moment, workspace.transform, workspace.product, workspace.values);
    deliver(tile, workspace.values);
  }

  /// The same with the workers inside the tile.
  void run_tile_inside(std::size_t tile, Execution& execution, double from, double to) const
  {
    FftBuffer transform(layout_.shape.size);
    std::vector<std::unique_ptr<FftBuffer>> products(std::size_t(execution.threads()));
    const std::vector<std::uint32_t> triangles = triangles_.row(tile);
    parallel_for(slab_count(), 1, execution, [&](std::size_t begin, std::size_t end, int) {
      for (std::size_t slab = begin; slab < end; ++slab) scan_slab(tile, triangles, slab, transform);
    }, from, from);
    transform_.forward(transform);
    std::vector<float> values(value_count(tile));
    parallel_for(moment_count, 1, execution, [&](std::size_t begin, std::size_t end, int worker) {
      std::unique_ptr<FftBuffer>& product = products[std::size_t(worker)];
      if (!product) product = std::make_unique<FftBuffer>(layout_.shape.size);
      for (std::size_t moment = begin; moment < end; ++moment)
        find_moment(tile, int(moment), transform, *product, values);
    }, from, to);
    deliver(tile, values);
  }

  const Surface& surface_;
  const TileLayout& layout_;
  const VoxelGrid fine_grid_;
  const int scale_;
  const MomentSink& sink_;
  const RealTransform transform_;
  const BallKernel kernel_;
  const IndexLists triangles_;
  std::vector<float> carries_;
  const std::size_t rows_, row_stride_;
};

class FftEngine : public MomentEngine {
 public:
  FftEngine(const Surface& surface, const Parameters& parameters)
      : surface_(surface), cells_per_radius_(parameters.fft_cells_per_radius),
        memory_(memory_limit_bytes(parameters.memory_limit_mb))
  {
  }

  void evaluate(const std::vector<double>& radii, const MomentSink& sink, Execution& execution) const override
  {
    const std::vector<TileLayout> layouts = make_layouts(radii);
    double total = 0, done = 0;
    for (const TileLayout& layout : layouts) total += layout.shape.cost;
    for (std::size_t scale = 0; scale < layouts.size(); ++scale) {
      const double next = done + layouts[scale].shape.cost;
      ScalePass(surface_, layouts[scale], int(scale), sink).run(execution, memory_ / 2, done / total, next / total);
      done = next;
    }
  }

  std::string description(const std::vector<double>& radii, const Execution&) const override
  {
    std::ostringstream text;
    text << "voxel FFT, " << cells_per_radius_ << " cells per radius; transforms per scale:";
    for (const TileLayout& layout : make_layouts(radii))
      text << ' ' << layout.tiles.size() << " x " << moment_count + 1 << " of " << layout.shape.size[0] << 'x'
           << layout.shape.size[1] << 'x' << layout.shape.size[2] << ';';
    return text.str();
  }

 private:
  std::vector<TileLayout> make_layouts(const std::vector<double>& radii) const
  {
    std::vector<TileLayout> layouts;
    for (const double radius : radii)
      layouts.push_back(make_tile_layout(surface_, radius, cells_per_radius_, memory_ / 2));
    return layouts;
  }

  const Surface& surface_;
  const double cells_per_radius_;
  const std::size_t memory_;
};

}  // namespace

std::unique_ptr<MomentEngine> make_fft_engine(const Surface& surface, const Parameters& parameters)
{
  if (!surface.is_closed()) {
    std::ostringstream text;
    text << "The voxel engine needs a closed surface, but this one has " << surface.report().boundary_edges
         << " boundary edges and " << surface.report().inconsistent_edges
         << " edges whose faces are not oriented alike. ";
    if (surface.report().nonfinite_vertices > 0)
      text << "The faces of " << surface.report().nonfinite_vertices
           << " vertices with coordinates that are not finite were left out. ";
    text << "Apply \"Close Holes\" and \"Re-Orient all faces coherently\" "
            "first, or choose the surface integral engine, which needs no closed mesh.";
    throw InputError(text.str());
  }
  return std::make_unique<FftEngine>(surface, parameters);
}

}  // namespace integral_invariant
