// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "support/shapes.h"

namespace accuracy {

void set_reference(TruthMesh& truth, std::size_t begin, std::size_t end)
{
  double squares = 0;
  for (std::size_t v = begin; v < end; ++v)
    squares += truth.kappa_max[v] * truth.kappa_max[v] + truth.kappa_min[v] * truth.kappa_min[v];
  truth.reference.resize(std::max(truth.reference.size(), end));
  const double rms = std::sqrt(squares / (2 * double(end - begin)));
  std::fill(truth.reference.begin() + std::ptrdiff_t(begin), truth.reference.begin() + std::ptrdiff_t(end), rms);
}

void draw_judged(TruthMesh& truth, std::vector<std::uint32_t> known, std::size_t count)
{
  truth.known.insert(truth.known.end(), known.begin(), known.end());
  std::mt19937 generator(20091);
  std::shuffle(known.begin(), known.end(), generator);
  known.resize(std::min(count, known.size()));
  std::sort(known.begin(), known.end());
  truth.judged.insert(truth.judged.end(), known.begin(), known.end());
}

TriangleMesh with_noise(const TruthMesh& truth, double sigma, std::uint32_t seed)
{
  TriangleMesh noisy = truth.mesh;
  if (sigma == 0) return noisy;
  std::mt19937 generator(seed);
  std::normal_distribution<double> gauss(0, sigma * test_support::average_edge_length(truth.mesh));
  for (std::size_t v = 0; v < noisy.positions.size(); ++v) noisy.positions[v] += truth.normal[v] * gauss(generator);
  return noisy;
}

}  // namespace accuracy
