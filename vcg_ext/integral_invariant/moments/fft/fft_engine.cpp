// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 1, FFT engine: per radius a grid, per tile of it one forward transform of the solid, ten products with kernels
// and ten inverse transforms, read at the tile's vertices.
#include "integral_invariant/moments/fft/fft_engine.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "integral_invariant/error.h"
#include "integral_invariant/moments/fft/antialias.h"
#include "integral_invariant/moments/fft/ball_spectrum.h"
#include "integral_invariant/moments/fft/fftw_plan.h"
#include "integral_invariant/moments/fft/scan_conversion.h"
#include "integral_invariant/moments/fft/spline.h"
#include "integral_invariant/moments/fft/tiling.h"
#include "integral_invariant/moments/fft/workspace_pool.h"
#include "integral_invariant/support/memory.h"

namespace integral_invariant {

namespace {

/// Cells along x that are scan-converted in one go; fixed, so that rounding does not depend on the threads.
constexpr int slab_width = 16;

/// Most bytes of carry planes at a time: stacks of tiles are worked on in batches that keep to it.
constexpr std::size_t largest_carries = std::size_t(128) << 20;

/// Bytes of the plane that holds what lies above one tile.
std::size_t carry_bytes(const Tiling& layout)
{
  return sizeof(float) * std::size_t(fine_size(layout.shape.size[0])) * std::size_t(fine_size(layout.shape.size[1]));
}

/// Bytes that a radius needs at the least: one worker, its kernels, the carry planes of the highest stack.
double least_bytes(const Tiling& layout)
{
  std::size_t highest = 0;
  for (std::size_t s = 0; s < layout.stack_count(); ++s)
    highest = std::max(highest, layout.stack_start[s + 1] - layout.stack_start[s]);
  return double(worker_bytes(layout.shape)) + double(BallSpectrum::bytes(layout.shape.size)) +
         double(highest) * double(carry_bytes(layout));
}

/// Everything about one radius that its tiles share.
class ScalePass {
 public:
  ScalePass(const Surface& surface, const Tiling& layout, int scale, const MomentSink& sink, Execution& execution)
      : surface_(surface),
        layout_(layout),
        fine_grid_{layout.grid.origin, layout.grid.step / 2},
        scale_(scale),
        sink_(sink),
        transform_(layout.shape.size),
        kernel_(layout.shape.size, layout.radius_cells),
        triangles_(tile_triangles(surface, layout, execution)),
        stack_triangles_(stack_triangles(surface, layout, execution)),
        rows_(std::size_t(layout.shape.size[1])),
        row_stride_(FftBuffer::row_stride(layout.shape.size))
  {
  }

  void run(Execution& execution, std::size_t memory, double from, double to)
  {
    const std::size_t most = std::max<std::size_t>(1, std::min(largest_carries, memory / 2) / carry_bytes(layout_));
    const double tiles = double(layout_.tiles.size());
    for (std::size_t stack = 0; stack < layout_.stack_count();) {
      const std::size_t begin = layout_.stack_start[stack], first = stack;
      while (stack < layout_.stack_count() && (stack == first || layout_.stack_start[stack + 1] - begin <= most))
        ++stack;
      const std::size_t end = layout_.stack_start[stack];
      run_stacks(first, stack, execution, memory / 2, from + (to - from) * double(begin) / tiles,
                 from + (to - from) * double(end) / tiles);
    }
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
  std::size_t plane_size() const { return carry_bytes(layout_) / sizeof(float); }

  /// All tiles of the stacks [first, last).
  void run_stacks(std::size_t first, std::size_t last, Execution& execution, std::size_t memory, double from, double to)
  {
    find_carries(first, last, execution, from, from);
    const std::size_t begin = layout_.stack_start[first], tiles = layout_.stack_start[last] - begin;
    const std::size_t threads = std::size_t(execution.threads());
    if (tiles < 2 * threads) {
      for (std::size_t tile = 0; tile < tiles; ++tile)
        run_tile_inside(begin + tile, execution, from + (to - from) * double(tile) / double(tiles),
                        from + (to - from) * double(tile + 1) / double(tiles));
      return;
    }
    // Of several threads, the one that asks the callback does nothing else.
    const auto check_if_alone = [&] {
      if (threads == 1) execution.check();
    };
    WorkspacePool pool(layout_.shape.size, std::clamp<std::size_t>(memory / worker_bytes(layout_.shape), 1, threads));
    parallel_for(
        tiles, 1, execution,
        [&](std::size_t from_tile, std::size_t to_tile, int) {
          for (std::size_t tile = from_tile; tile < to_tile; ++tile)
            pool.with_workspace([&](Workspace& workspace) { run_tile(begin + tile, workspace, check_if_alone); });
        },
        from, to);
  }

  void find_carries(std::size_t first_stack, std::size_t last_stack, Execution& execution, double from, double to)
  {
    first_carried_ = layout_.stack_start[first_stack];
    carries_.resize((layout_.stack_start[last_stack] - first_carried_) * plane_size());
    parallel_for(
        last_stack - first_stack, 1, execution,
        [&](std::size_t begin, std::size_t end, int) {
          for (std::size_t stack = first_stack + begin; stack < first_stack + end; ++stack) {
            const std::size_t first = layout_.stack_start[stack];
            std::vector<std::int64_t> tops;
            for (std::size_t tile = first; tile < layout_.stack_start[stack + 1]; ++tile)
              tops.push_back(fine_box(tile).begin[2] + fine_box(tile).size[2]);
            carry_planes(surface_, fine_grid_, fine_box(first), stack_triangles_.row(stack), tops, carry_of(first));
          }
        },
        from, to);
  }

  float* carry_of(std::size_t tile) { return carries_.data() + (tile - first_carried_) * plane_size(); }
  const float* carry_of(std::size_t tile) const { return carries_.data() + (tile - first_carried_) * plane_size(); }

  std::size_t slab_count() const { return std::size_t((layout_.shape.size[0] + slab_width - 1) / slab_width); }

  void scan_slab(std::size_t tile, const std::vector<std::uint32_t>& triangles, std::size_t slab,
                 FftBuffer& buffer) const
  {
    const int offset = int(slab) * slab_width;
    std::array<int, 3> size = layout_.shape.size;
    size[0] = std::min(slab_width, size[0] - offset);
    CellBox box = fine_box(tile);
    box.begin[0] += 2 * offset;
    box.size[0] = fine_size(size[0]);
    std::vector<float> fine(std::size_t(box.size[0]) * std::size_t(box.size[1]) * std::size_t(box.size[2]));
    scan_convert(surface_, fine_grid_, box, triangles,
                 carry_of(tile) + 2 * std::size_t(offset) * std::size_t(box.size[1]), fine.data(),
                 std::size_t(box.size[2]));
    downsample(fine, size, buffer.reals() + std::size_t(offset) * rows_ * row_stride_, row_stride_);
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
      moments.second =
          Symmetric3{double(v[4]), double(v[5]), double(v[6]), double(v[7]), double(v[8]), double(v[9])} * h5;
      sink_(lists.indices[i], scale_, moments);
    }
  }

  std::size_t value_count(std::size_t tile) const
  {
    return (layout_.tile_vertices.start[tile + 1] - layout_.tile_vertices.start[tile]) * moment_count;
  }

  /// Calls `between` between its steps.
  template <class Between>
  void run_tile(std::size_t tile, Workspace& workspace, const Between& between) const
  {
    const std::vector<std::uint32_t> triangles = triangles_.row(tile);
    for (std::size_t slab = 0; slab < slab_count(); ++slab) scan_slab(tile, triangles, slab, workspace.transform);
    between();
    transform_.forward(workspace.transform);
    workspace.values.resize(value_count(tile));
    for (int moment = 0; moment < moment_count; ++moment) {
      between();
      find_moment(tile, moment, workspace.transform, workspace.product, workspace.values);
    }
    deliver(tile, workspace.values);
  }

  /// The same with the workers inside the tile.
  void run_tile_inside(std::size_t tile, Execution& execution, double from, double to) const
  {
    FftBuffer transform(layout_.shape.size);
    std::vector<std::unique_ptr<FftBuffer>> products(std::size_t(execution.threads()));
    const std::vector<std::uint32_t> triangles = triangles_.row(tile);
    parallel_for(
        slab_count(), 1, execution,
        [&](std::size_t begin, std::size_t end, int) {
          for (std::size_t slab = begin; slab < end; ++slab) scan_slab(tile, triangles, slab, transform);
        },
        from, from);
    transform_.forward(transform);
    execution.report(from);
    std::vector<float> values(value_count(tile));
    parallel_for(
        moment_count, 1, execution,
        [&](std::size_t begin, std::size_t end, int worker) {
          std::unique_ptr<FftBuffer>& product = products[std::size_t(worker)];
          if (!product) product = std::make_unique<FftBuffer>(layout_.shape.size);
          for (std::size_t moment = begin; moment < end; ++moment)
            find_moment(tile, int(moment), transform, *product, values);
        },
        from, to);
    deliver(tile, values);
  }

  const Surface& surface_;
  const Tiling& layout_;
  const VoxelGrid fine_grid_;
  const int scale_;
  const MomentSink& sink_;
  const RealTransform transform_;
  const BallSpectrum kernel_;
  const IndexLists triangles_, stack_triangles_;
  std::size_t first_carried_ = 0;  ///< the tile whose plane carries_ begins with
  std::vector<float> carries_;
  const std::size_t rows_, row_stride_;
};

class FftEngine : public MomentEngine {
 public:
  FftEngine(const Surface& surface, const Parameters& parameters)
      : surface_(surface),
        cells_per_radius_(parameters.fft_cells_per_radius),
        memory_(memory_limit_bytes(parameters.memory_limit_mb)),
        memory_limit_mb_(parameters.memory_limit_mb)
  {
  }

  void evaluate(const std::vector<double>& radii, const MomentSink& sink, Execution& execution) const override
  {
    const std::vector<Tiling> layouts = make_layouts(radii, execution);
    double total = 0, done = 0;
    for (const Tiling& layout : layouts) {
      total += layout.shape.cost;
      require_memory(least_bytes(layout), memory_limit_mb_,
                     "The voxel grid (" + std::to_string(layout.tiles.size()) + " tiles)",
                     "Lower fft_cells_per_radius, raise r_min");
    }
    for (std::size_t scale = 0; scale < layouts.size(); ++scale) {
      const double next = done + layouts[scale].shape.cost;
      execution.report(done / total);
      ScalePass pass(surface_, layouts[scale], int(scale), sink, execution);
      pass.run(execution, memory_, done / total, next / total);
      done = next;
    }
  }

  std::string description(const std::vector<double>& radii, Execution& execution) const override
  {
    std::ostringstream text;
    text << "voxel FFT, " << cells_per_radius_ << " cells per radius; transforms per scale:";
    for (const Tiling& layout : make_layouts(radii, execution))
      text << ' ' << layout.tiles.size() << " x " << moment_count + 1 << " of " << layout.shape.size[0] << 'x'
           << layout.shape.size[1] << 'x' << layout.shape.size[2] << ';';
    return text.str();
  }

 private:
  std::vector<Tiling> make_layouts(const std::vector<double>& radii, Execution& execution) const
  {
    std::vector<Tiling> layouts;
    for (const double radius : radii)
      layouts.push_back(make_tiling(surface_, radius, cells_per_radius_, memory_ / 2, execution));
    return layouts;
  }

  const Surface& surface_;
  const double cells_per_radius_;
  const std::size_t memory_, memory_limit_mb_;
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
