// SPDX-License-Identifier: GPL-3.0-or-later
// Time, memory and the longest wait between two calls of the callback as meshes grow; prints the table of
// docs/robustness.md.
//   big_meshes [million vertices ...]        default: 0.1 1 5 10
// Each size and setting runs in its own process, so that peak memory is measured separately.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "integral_invariant/curvature.h"
#include "resource_use.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

/// A noisy, irregular torus with about the given number of vertices.
TriangleMesh big_mesh(double vertices)
{
  const int around = int(std::lround(std::sqrt(vertices / 0.55) / 2)) * 2;
  const TriangleMesh regular = torus(1, 0.4, around, int(0.55 * around));
  const double edge = average_edge_length(regular);
  return with_normal_noise(with_tangential_jitter(regular, 0.25 * edge), 0.1 * edge);
}

bool all_finite(const Result& r)
{
  for (std::size_t v = 0; v < r.kappa_max.size(); ++v)
    if (!std::isfinite(r.kappa_max[v]) || !std::isfinite(r.kappa_min[v]) || !std::isfinite(r.radius[v])) return false;
  return true;
}

void print_row(const char* settings, const Parameters& parameters, double million)
{
  const TriangleMesh mesh = big_mesh(1e6 * million);
  const double before = memory_bytes("VmRSS:"), cpu_start = cpu_seconds(), wall_start = wall_seconds();
  double last_call = wall_start, longest_wait = 0;
  const Result result = compute_curvature(mesh, parameters, [&](int, const char*) {
    const double now = wall_seconds();
    longest_wait = std::max(longest_wait, now - last_call);
    last_call = now;
    return true;
  });
  const double cpu = cpu_seconds() - cpu_start, wall = wall_seconds() - wall_start;
  const double n = double(mesh.positions.size());
  std::printf("| %s | %.2f | %.1f | %.1f | %.1f | %.2f | %.2f | %.2f | %s |\n", settings, n / 1e6, wall, 1e6 * wall / n,
              1e6 * cpu / n, memory_bytes("VmHWM:") / 1e9, (memory_bytes("VmHWM:") - before) / n / 1e3, longest_wait,
              all_finite(result) ? "yes" : "NO");
  std::fflush(stdout);
  if (!all_finite(result)) std::exit(1);
}

}  // namespace

int main(int argc, char** argv)
{
  std::vector<double> sizes;
  for (int i = 1; i < argc; ++i) {
    sizes.push_back(std::atof(argv[i]));
    if (sizes.back() > 0) continue;
    std::fprintf(stderr, "usage: big_meshes [million vertices ...]\n");
    return EXIT_FAILURE;
  }
  if (sizes.empty()) sizes = {0.1, 1, 5, 10};
  Parameters published = published_method();
  published.scales = 8;
  const struct {
    const char* name;
    Parameters parameters;
  } settings[] = {{"published method", published}, {"default", Parameters{}}};

  std::printf(
      "| settings | million vertices | wall s | wall us/vertex | CPU us/vertex | peak GB in all | GB per million "
      "vertices "
      "beyond the mesh | longest wait s | finite |\n|---|---|---|---|---|---|---|---|---|\n");
  std::fflush(stdout);
  bool failed = false;
  for (const auto& setting : settings)
    for (const double million : sizes) {
      const pid_t child = fork();
      if (child == 0) {
        print_row(setting.name, setting.parameters, million);
        std::_Exit(0);
      }
      int status = 1;
      waitpid(child, &status, 0);
      if (status != 0) std::printf("| %s | %.2f | failed |\n", setting.name, million);
      failed = failed || status != 0;
    }
  return failed;
}
