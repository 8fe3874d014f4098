// SPDX-License-Identifier: GPL-3.0-or-later
// Time of the voxel engine against the bare transforms, at the grids of [Lai09 Table 1] with eight scales. Two counts
// of bare transforms, same precision and threads, measured in the same run: those of the published scheme (one forward
// and ten inverse a scale, all of the whole grid), and those that the engine really makes (eleven per tile, each scale
// on a grid of its own). Prints a table; with --json, one JSON object a line.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "integral_invariant/moments/fft/ball_spectrum.h"
#include "integral_invariant/moments/fft/fft_engine.h"
#include "integral_invariant/moments/fft/fftw_plan.h"
#include "integral_invariant/moments/fft/tiling.h"
#include "support/shapes.h"

using namespace integral_invariant;

namespace {

using Size = std::array<int, 3>;
constexpr int scale_count = 8;

double seconds_of(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Seconds of `count` inverse transforms on all threads; a sample of them, extrapolated where there are many.
double transform_seconds(const Size& size, double count, Execution& execution)
{
  const RealTransform transform(size);
  std::vector<std::unique_ptr<FftBuffer>> buffers;
  for (int i = 0; i < execution.threads(); ++i) {
    buffers.push_back(std::make_unique<FftBuffer>(size));
    std::fill_n(buffers.back()->reals(), FftBuffer::bytes(size) / sizeof(float), 0.0f);
  }
  const std::size_t run = std::size_t(std::min(count, std::max(20.0, 4e8 / (double(size[0]) * size[1] * size[2]))));
  const auto body = [&](std::size_t begin, std::size_t end, int worker) {
    for (std::size_t i = begin; i < end; ++i) transform.inverse(*buffers[std::size_t(worker)]);
  };
  parallel_for(run, 1, execution, body);
  return seconds_of([&] { parallel_for(run, 1, execution, body); }) * count / double(run);
}

/// A bumpy closed surface whose bounding box has the proportions of the grid.
TriangleMesh bumpy_shape(const Size& grid)
{
  TriangleMesh mesh = test_support::icosphere(6);
  Vec3 reach;
  for (Vec3& p : mesh.positions) {
    p *= 1 + 0.08 * std::sin(7 * p.x) * std::sin(6 * p.y + 1) * std::sin(8 * p.z);
    reach = {std::max(reach.x, std::abs(p.x)), std::max(reach.y, std::abs(p.y)), std::max(reach.z, std::abs(p.z))};
  }
  for (Vec3& p : mesh.positions)
    p = {p.x / reach.x * grid[0] / 2, p.y / reach.y * grid[1] / 2, p.z / reach.z * grid[2] / 2};
  return mesh;
}

void measure(const Size& grid, bool json)
{
  const Surface surface(bumpy_shape(grid));
  const Parameters parameters;
  std::vector<double> radii;  // the smallest has fft_cells_per_radius cells of the asked grid
  for (int i = 1; i <= scale_count; ++i) radii.push_back(i * parameters.fft_cells_per_radius / surface.unit());
  Execution execution;
  const auto engine = make_fft_engine(surface, parameters);
  const auto sink = [](std::size_t, int, const BallMoments&) {};
  const double time = seconds_of([&] { engine->evaluate(radii, sink, execution); });
  double own = 0;
  for (const double radius : radii) {
    const Tiling layout =
        make_tiling(surface, radius, parameters.fft_cells_per_radius, std::size_t(1) << 33, execution);
    own += transform_seconds(layout.shape.size, double(layout.tiles.size()) * (1 + moment_count), execution);
  }
  const double published = transform_seconds(grid, 1 + moment_count * scale_count, execution);
  std::printf(json ? "{\"grid\": [%d, %d, %d], \"engine_s\": %.3f, \"published_transforms_s\": %.3f, \"ratio\": %.3f, "
                     "\"own_transforms_s\": %.3f, \"own_ratio\": %.3f}\n"
                   : "| %d x %d x %d | %.2f | %.2f | %.2f | %.2f | %.2f |\n",
              grid[0], grid[1], grid[2], time, published, time / published, own, time / own);
}

}  // namespace

int main(int argc, char** argv)
{
  const bool json = argc > 1 && std::strcmp(argv[1], "--json") == 0;
  if (!json)
    std::printf(
        "| grid | engine, s | 81 transforms of the grid, s | ratio | the engine's own transforms, s | ratio |\n"
        "|---|---|---|---|---|---|\n");
  for (const Size& grid : {Size{204, 172, 184}, Size{194, 112, 332}, Size{192, 228, 174}, Size{136, 332, 136}})
    measure(grid, json);
}
