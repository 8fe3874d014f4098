// SPDX-License-Identifier: GPL-3.0-or-later
// Speed and accuracy of the surface engine; prints the tables of docs/surface_engine.md.
//   surface_engine speed [threads]     CPU and wall time per vertex over mesh size and largest radius, memory
//   surface_engine single THREADS N linear|geometric R   one row of it: N vertices around the torus, largest radius R
//   surface_engine accuracy            error of curvature against the closed forms throughout, per noise and radius
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "integral_invariant/ball_curvature/tensor_field.h"
#include "integral_invariant/ball_curvature/curvature_tensor.h"
#include "integral_invariant/moments/surface/surface_engine.h"
#include "resource_use.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

std::vector<double> linear(int n, double largest)
{
  std::vector<double> radii;
  for (int i = 1; i <= n; ++i) radii.push_back(largest * i / n);
  return radii;
}

std::vector<double> geometric(int n, double largest)
{
  std::vector<double> radii;
  for (int i = 0; i < n; ++i) radii.push_back(std::pow(largest, double(i) / (n - 1)));
  return radii;
}

TriangleMesh bumpy_torus(int n)
{
  TriangleMesh mesh = torus(1, 0.4, n, int(0.55 * n));
  const double edge = average_edge_length(mesh);
  return with_normal_noise(with_tangential_jitter(mesh, 0.25 * edge), 0.1 * edge);
}

void measure_speed(const std::string& name, const Surface& surface, const std::vector<double>& radii, int threads)
{
  double best_wall = 1e9, best_cpu = 1e9, best_prepare = 1e9;
  const double before = memory_bytes("VmRSS:");
  double checksum = 0;
  const int repeats = surface.vertex_count() > 100000 ? 1 : 3;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    Execution execution(threads);
    std::vector<double> volume(surface.vertex_count());
    const double wall = wall_seconds(), cpu = cpu_seconds();
    const auto engine = make_surface_engine(surface, published_method(), execution);
    best_prepare = std::min(best_prepare, wall_seconds() - wall);
    engine->evaluate(
        radii, [&](std::size_t v, int, const BallMoments& m) { volume[v] += m.volume; }, execution);
    best_wall = std::min(best_wall, wall_seconds() - wall);
    best_cpu = std::min(best_cpu, cpu_seconds() - cpu);
    checksum += volume[0];
  }
  const double n = double(surface.vertex_count());
  std::printf("| %-12s | %8.0f | %4.0f | %6.2f | %6.2f | %6.2f | %6.3f | %5.0f |\n", name.c_str(), n, radii.back(),
              1e6 * best_cpu / n, 1e6 * best_wall / n, 1e6 * best_prepare / n, best_wall,
              (memory_bytes("VmHWM:") - before) / n);
  std::fflush(stdout);
  if (checksum == 0) std::abort();
}

void speed(int threads, int largest, bool far)
{
  std::printf(
      "| scales | vertices | r_max | CPU us/v | wall us/v | of it prepare | wall s | bytes/v "
      "|\n|---|---|---|---|---|---|---|---|\n");
  for (const int n : {135, 546, 1907}) {
    if (n > largest) break;
    const Surface surface(bumpy_torus(n));
    measure_speed("linear", surface, linear(8, 8), threads);
    if (n == 546) measure_speed("geometric", surface, geometric(8, 8), threads);
    if (n == 546 && far) measure_speed("geometric", surface, geometric(8, 64), threads);
  }
}

struct Errors {
  double rms = 0, largest = 0;
};

std::vector<std::vector<double>> curvatures(const Surface& surface, const std::vector<double>& radii,
                                            Exactness exactness)
{
  std::vector<std::vector<double>> values(radii.size(), std::vector<double>(2 * surface.vertex_count()));
  Parameters parameters = published_method();
  parameters.exactness = exactness;
  Execution execution;
  make_surface_engine(surface, parameters, execution)
      ->evaluate(
          radii,
          [&](std::size_t v, int k, const BallMoments& m) {
            const PrincipalCurvatures kappa = principal_curvatures(curvature_tensor(m, radii[std::size_t(k)]));
            values[std::size_t(k)][2 * v] = kappa.kappa_max;
            values[std::size_t(k)][2 * v + 1] = kappa.kappa_min;
          },
          execution);
  return values;
}

/// A row of errors per exactness, jitter and noise (in average edges).
void accuracy(const char* name, const TriangleMesh& smooth, const std::vector<double>& radii,
              const std::vector<Exactness>& kinds, const std::vector<double>& jitters)
{
  std::printf("\n%s, %zu vertices\n| exactness | jitter | noise |", name, smooth.positions.size());
  for (const double r : radii) std::printf(" %11.1f |", r);
  std::printf("\n");
  const double edge = average_edge_length(smooth);
  for (const double jitter : jitters)
    for (const double noise : {0.0, 0.1, 0.5}) {
      const Surface surface(with_normal_noise(with_tangential_jitter(smooth, jitter * edge), noise * edge));
      const auto truth = curvatures(surface, radii, Exactness::exact);
      for (const Exactness exactness : kinds) {
        const auto got = curvatures(surface, radii, exactness);
        std::printf("| %s | %4.2f | %4.1f |", exactness == Exactness::fast ? "fast    " : "balanced", jitter, noise);
        for (std::size_t k = 0; k < radii.size(); ++k) {
          double error = 0, square = 0, largest = 0;
          for (std::size_t i = 0; i < got[k].size(); ++i) {
            const double e = std::abs(got[k][i] - truth[k][i]);
            error += e * e;
            square += truth[k][i] * truth[k][i];
            largest = std::max(largest, e);
          }
          std::printf(" %5.3f %5.1f |", 100 * std::sqrt(error / square),
                      100 * largest / std::sqrt(square / double(got[k].size())));
        }
        std::printf("\n");
        std::fflush(stdout);
      }
    }
}

void accuracy()
{
  std::printf("RMS error of the curvature relative to its RMS, in percent (and largest error relative to the RMS)\n");
  const std::vector<double> usual = {1, 1.5, 2, 3, 3.5, 4, 5, 6, 8}, large = {2, 8, 16, 32, 64};
  accuracy("torus", torus(1, 0.4, 160, 88), usual, {Exactness::fast, Exactness::balanced}, {0.0, 0.4});
  accuracy("bumpy sphere", bumpy_sphere(6), usual, {Exactness::balanced}, {0.4});
  accuracy("bumpy sphere", bumpy_sphere(7), large, {Exactness::balanced}, {0.4});
  accuracy("coarse torus that the largest balls swallow", torus(1, 0.4, 300, 165), large, {Exactness::balanced}, {0.4});
}

}  // namespace

int main(int argc, char** argv)
{
  if (argc > 1 && std::strcmp(argv[1], "accuracy") == 0)
    accuracy();
  else if (argc > 5 && std::strcmp(argv[1], "single") == 0)
    measure_speed(argv[4], Surface(bumpy_torus(std::atoi(argv[3]))),
                  argv[4][0] == 'l' ? linear(8, std::atof(argv[5])) : geometric(8, std::atof(argv[5])),
                  std::atoi(argv[2]));
  else
    speed(argc > 2 ? std::atoi(argv[2]) : 2, argc > 3 ? std::atoi(argv[3]) : 2000, argc <= 4);
}
