// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include "integral_invariant/curvature.h"
#include "integral_invariant/support/pi.h"
#include "support/ply_file.h"
#include "support/shapes.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

constexpr std::array<double, 3> thresholds{0.001, 0.01, 0.1};

struct Moves {
  std::array<double, 3> share{};  ///< of vertices over each threshold
  double largest_over_error = 0;
};

double rms_curvature(const Result& r)
{
  double squares = 0;
  for (std::size_t v = 0; v < r.kappa_max.size(); ++v)
    squares += r.kappa_max[v] * r.kappa_max[v] + r.kappa_min[v] * r.kappa_min[v];
  return std::sqrt(squares / (2 * double(r.kappa_max.size())));
}

Moves moves_between(const Result& before, const Result& after)
{
  const double floor = 0.1 * rms_curvature(before);
  const std::size_t n = before.kappa_max.size();
  Moves moves;
  for (std::size_t v = 0; v < n; ++v) {
    double relative = 0, largest = 0;
    for (const auto values : {&Result::kappa_max, &Result::kappa_min}) {
      const double k = (before.*values)[v], move = std::abs((after.*values)[v] - k);
      relative = std::max(relative, move / std::max(std::abs(k), floor));
      largest = std::max(largest, move);
    }
    for (std::size_t i = 0; i < thresholds.size(); ++i) moves.share[i] += (relative > thresholds[i]) / double(n);
    if (before.standard_error[v] > 0)
      moves.largest_over_error = std::max(moves.largest_over_error, largest / before.standard_error[v]);
  }
  return moves;
}

/// As a host that stores single precision has it.
TriangleMesh in_single_precision(TriangleMesh mesh)
{
  for (Vec3& p : mesh.positions) p = {double(float(p.x)), double(float(p.y)), double(float(p.z))};
  return mesh;
}

}  // namespace

void print_frame_dependence(const std::vector<std::string>& paths, std::uint32_t seed)
{
  constexpr int rotations = 3;
  std::mt19937 generator(seed);
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> angle(0.2, pi);
  std::printf("Seed %u.\n\n| mesh | method | over 0.1 %% | over 1 %% | over 10 %% | largest / standard error |\n",
              seed);
  std::puts("|---|---|---|---|---|---|");
  for (const std::string& path : paths) {
    const TriangleMesh mesh = test_support::read_ply(path).mesh();
    const Result before = compute_curvature(mesh, {}), published = compute_curvature(mesh, published_method());
    for (int i = 0; i < rotations; ++i) {
      const Vec3 axis = normalized({gauss(generator), gauss(generator), gauss(generator)});
      const TriangleMesh turned = test_support::rotated(mesh, axis, angle(generator));
      const auto print = [&](const char* method, const Result& first, const Result& second) {
        const Moves m = moves_between(first, second);
        std::printf("| %s | %s | %.5f | %.5f | %.5f | %.2f |\n", path.substr(path.rfind('/') + 1).c_str(), method,
                    m.share[0], m.share[1], m.share[2], m.largest_over_error);
      };
      print("default", before, compute_curvature(turned, {}));
      print("default, single precision", before, compute_curvature(in_single_precision(turned), {}));
      print("published", published, compute_curvature(turned, published_method()));
      std::fflush(stdout);
    }
  }
}

}  // namespace accuracy
