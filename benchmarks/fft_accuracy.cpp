// SPDX-License-Identifier: GPL-3.0-or-later
// Error of the voxel engine's curvature against its grid step: per shape and cells per radius the difference of κ·r to
// that on a fine grid of the same mesh (which leaves the error of the grid alone). Prints the table of
// docs/fft_engine.md.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "integral_invariant/ball_curvature/curvature_tensor.h"
#include "integral_invariant/moments/fft/fft_engine.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

struct Curvatures {
  std::vector<double> values;  ///< κ_max and κ_min of each vertex
  double seconds;
};

Curvatures curvatures_times_radius(const Surface& surface, double radius, double cells)
{
  Parameters parameters;
  parameters.fft_cells_per_radius = cells;
  Execution execution;
  Curvatures result{std::vector<double>(2 * surface.vertex_count()), 0};
  const auto sink = [&](std::size_t v, int, const BallMoments& moments) {
    const PrincipalCurvatures k = principal_curvatures(curvature_tensor(moments, radius));
    result.values[2 * v] = k.kappa_max * radius;
    result.values[2 * v + 1] = k.kappa_min * radius;
  };
  const auto start = std::chrono::steady_clock::now();
  make_fft_engine(surface, parameters)->evaluate({radius}, sink, execution);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

void measure(const std::string& name, const TriangleMesh& mesh, double radius)
{
  const Surface surface(rotated(mesh, normalized({1, 2, 3}), 0.7));
  const Curvatures reference = curvatures_times_radius(surface, radius, 24);
  double before = 0, cells_before = 0;
  for (const double cells : {2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0}) {
    const Curvatures measured = curvatures_times_radius(surface, radius, cells);
    double sum = 0, largest = 0;
    for (std::size_t i = 0; i < measured.values.size(); ++i) {
      const double error = std::abs(measured.values[i] - reference.values[i]);
      sum += error * error;
      largest = std::max(largest, error);
    }
    const double rms = std::sqrt(sum / double(measured.values.size()));
    std::printf("| %-14s | %4.0f | %4.0f | %9.2e | %9.2e | %5.2f | %6.2f |\n", name.c_str(), radius, cells, rms,
                largest, before > 0 ? std::log(before / rms) / std::log(cells / cells_before) : 0.0, measured.seconds);
    before = rms;
    cells_before = cells;
  }
}

}  // namespace

int main()
{
  std::printf(
      "| shape | r/edge | cells per radius | rms error of kr | largest | order | seconds "
      "|\n|---|---|---|---|---|---|---|\n");
  measure("sphere", icosphere(5), 8);
  measure("sphere", icosphere(5), 3);
  measure("torus", torus(1, 0.4, 160, 64), 4);
  measure("box", box(1, 1, 1, 0.04), 5);
}
