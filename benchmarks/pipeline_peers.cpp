// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of the whole filter next to other estimators of curvature; prints a table of docs/surface_engine.md.
//   pipeline_peers [threads] [vertices around the torus]
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "integral_invariant/curvature.h"
#include "peers/peers.h"
#include "resource_use.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

/// Resets the kernel's record of the peak memory.
void reset_peak_memory() { std::ofstream("/proc/self/clear_refs") << "5"; }

/// Runs one method and prints its row. The others are compared with the first.
class Table {
 public:
  explicit Table(double vertices) : vertices_(vertices)
  {
    std::printf("| method | scales | threads | CPU s | wall s | CPU us/vertex | CPU, ours = 1 | peak bytes/vertex |\n");
    std::printf("|---|---|---|---|---|---|---|---|\n");
  }

  void run(const char* name, int scales, int threads, int repeats, const std::function<double()>& method)
  {
    double cpu = 1e300, wall = 1e300, peak = 0, check = 0;
    for (int i = 0; i < repeats; ++i) {
      reset_peak_memory();
      const double before = memory_bytes("VmRSS:"), cpu_start = cpu_seconds(), wall_start = wall_seconds();
      check = method();
      cpu = std::min(cpu, cpu_seconds() - cpu_start);
      wall = std::min(wall, wall_seconds() - wall_start);
      peak = std::max(peak, memory_bytes("VmHWM:") - before);
    }
    if (ours_ == 0) ours_ = cpu;
    std::printf("| %s | %d | %d | %.2f | %.2f | %.1f | %.2f | %.0f |\n", name, scales, threads, cpu, wall,
                1e6 * cpu / vertices_, cpu / ours_, peak / vertices_);
    std::fflush(stdout);
    if (!std::isfinite(check)) std::abort();
  }

 private:
  double vertices_, ours_ = 0;
};

double mean_curvature(const Result& result)
{
  double sum = 0;
  for (const double k : result.kappa_max) sum += std::fabs(k);
  return sum / double(result.kappa_max.size());
}

}  // namespace

int main(int argc, char** argv)
{
  const int threads = argc > 1 ? std::atoi(argv[1]) : 2, around = argc > 2 ? std::atoi(argv[2]) : 546;
  TriangleMesh mesh = torus(1, 0.4, around, int(0.55 * around));
  const double edge = average_edge_length(mesh);
  mesh = with_normal_noise(with_tangential_jitter(mesh, 0.25 * edge), 0.1 * edge);
  std::printf("%zu vertices, %zu triangles\n\n", mesh.positions.size(), mesh.triangles.size());

  Table table(double(mesh.positions.size()));
  Result ours;
  const auto filter = [&](EngineKind engine, int workers) {
    Parameters parameters = published_method();  // eight scales from one to eight edges
    parameters.scales = 8;
    parameters.engine = engine;
    parameters.threads = workers;
    if (engine == EngineKind::surface_integral) ours = {};  // frees its memory before the next run
    Result result = compute_curvature(mesh, parameters);
    const double mean = mean_curvature(result);
    if (engine == EngineKind::surface_integral) ours = std::move(result);
    return mean;
  };
  // The other libraries use one thread.
  for (const int workers : threads > 1 ? std::vector<int>{1, threads} : std::vector<int>{1})
    table.run("whole filter, surface engine", 8, workers, 5,
              [&] { return filter(EngineKind::surface_integral, workers); });
  table.run("whole filter, FFT engine", 8, threads, 1, [&] { return filter(EngineKind::volume_fft, threads); });
#ifdef II_WITH_VCG
  table.run("VCG quadric fitting (1-ring)", 1, 1, 1, [&] { return peers::vcg_quadric(mesh); });
  table.run("VCG scale dependent quadric fitting", 1, 1, 1,
            [&] { return peers::vcg_scale_dependent_quadric(mesh, 8 * edge); });
#endif
#ifdef II_WITH_CGAL
  table.run("CGAL jet fitting, degree 2", 1, 1, 1, [&] { return peers::cgal_jet(mesh, 8 * edge); });
#endif

  std::printf("\nStages of the filter, last run:");
  for (const StageTime& stage : ours.stages) std::printf(" %s %.3f s;", stage.stage.c_str(), stage.seconds);
  std::printf("\n");
}
