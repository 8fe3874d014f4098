// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/constant_radius.h"

#include <array>
#include <cmath>

#include "integral_invariant/ball_curvature/ball_bias.h"
#include "integral_invariant/ball_curvature/offset_free.h"
#include "integral_invariant/moments/engine.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

constexpr int radius_count = 14;
constexpr double least_radius = 1.5, largest_radius = 40;

std::vector<double> radii()
{
  std::vector<double> r;
  for (int i = 0; i < radius_count; ++i)
    r.push_back(least_radius * std::pow(largest_radius / least_radius, i / (radius_count - 1.0)));
  return r;
}

Estimate estimate(const CurvatureTensor& tensor, double unit)
{
  const PrincipalCurvatures k = principal_curvatures(tensor);
  return {k.kappa_max / unit, k.kappa_min / unit, k.dir_max, 0};
}

}  // namespace

ConstantRadius best_constant_radius(const TruthMesh& truth)
{
  Execution execution;
  const Surface surface(truth.mesh, execution);
  const std::vector<double> r = radii();
  constexpr std::size_t not_judged = ~std::size_t(0);
  std::vector<std::size_t> place(truth.mesh.positions.size(), not_judged);
  for (std::size_t i = 0; i < truth.judged.size(); ++i) place[truth.judged[i]] = i;

  using Estimates = std::vector<Estimate>;
  std::array<std::vector<Estimates>, 2> all;
  for (auto& one : all) one.assign(r.size(), Estimates(truth.judged.size()));
  make_moment_engine(surface, {}, execution)
      ->evaluate(
          r,
          [&](std::size_t v, int scale, const BallMoments& moments) {
            if (place[v] == not_judged) return;
            const std::size_t s = std::size_t(scale);
            const OffsetFreeMeasure measure = offset_free_measure(moments, r[s]);
            all[0][s][place[v]] = estimate(measure.tensor, surface.unit());
            all[1][s][place[v]] = estimate(correct_ball_bias(measure.tensor, r[s], measure.offset, 0), surface.unit());
          },
          execution);

  ConstantRadius best;
  best.metrics.mean = INFINITY;
  for (const bool bias_free : {false, true})
    for (std::size_t s = 0; s < r.size(); ++s) {
      const Metrics metrics = compare(truth, all[bias_free][s]);
      if (metrics.mean < best.metrics.mean) best = {r[s], bias_free, metrics};
    }
  return best;
}

}  // namespace accuracy
