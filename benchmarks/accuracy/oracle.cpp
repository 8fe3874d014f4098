// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <Eigen/Dense>

#include "integral_invariant/curvature/bias.h"
#include "integral_invariant/curvature/offset_free.h"
#include "integral_invariant/curvature/tangent_frame.h"
#include "integral_invariant/curvature/vertex_fit.h"
#include "integral_invariant/moments/engine.h"
#include "integral_invariant/radius/noise.h"
#include "integral_invariant/radius/scales.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

/// Mean curvature and deviator in the true tangent frame, normalised unit.
using Components = std::array<double, 3>;

Components components_of(const CurvatureTensor& t, const Vec3& normal, const Vec3& u)
{
  const TensorComponents c = integral_invariant::components_of(t, {normal, u, cross(normal, u)});
  return {c.mean, c.deviator[0], c.deviator[1]};
}

double kappa_error(const Components& c, const Components& truth)
{
  const double half = std::hypot(c[1], c[2]), true_half = std::abs(truth[1]);
  return (std::abs(c[0] + half - truth[0] - true_half) + std::abs(c[0] - half - truth[0] + true_half)) / 2;
}

struct Candidates {
  std::size_t count = 0;
  std::vector<Components> values;  ///< n × count: the fit to the nearest vertices, then the balls from small to large
  std::vector<Components> truth;
  const Components& at(std::size_t v, std::size_t c) const { return values[v * count + c]; }
};

Components between(const Components& a, const Components& b, double t)
{
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

Candidates make_candidates(const TruthMesh& truth, const TriangleMesh& noisy)
{
  constexpr double surface_share = 0.5;  // as in the estimator
  Execution execution;
  const Parameters p;
  const Surface surface(noisy);
  const std::size_t n = surface.vertex_count();
  const std::vector<double> radii = scale_radii(p, surface.unit());
  TensorField tensors(n, radii);
  std::vector<float> offsets(n * radii.size());
  make_moment_engine(surface, p, execution)
      ->evaluate(
          radii,
          [&](std::size_t v, int i, const BallMoments& moments) {
            const OffsetFreeMeasure m = offset_free_measure(moments, radii[std::size_t(i)]);
            tensors.set(v, i, m.tensor);
            offsets[v * radii.size() + std::size_t(i)] = float(m.offset);
          },
          execution);
  const std::vector<VertexFit> fits = fit_vertices(surface, tensors, execution);
  const Noise noise = estimate_noise(surface, tensors, offsets, fits, 0, execution);

  Candidates all;
  all.count = radii.size() + 1;
  for (std::size_t v = 0; v < n; ++v) {
    const Vec3 normal = truth.normal[v], u = truth.dir_max[v];
    all.values.push_back(components_of(fits[v].tensor, normal, u));
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const CurvatureTensor t = without_own_bias(tensors.at_scale(v, int(i)), radii[i], noise.offset[v],
                                                 surface_share * noise.sigma[v] * noise.sigma[v]);
      all.values.push_back(components_of(t, normal, u));
    }
    all.truth.push_back({(truth.kappa_max[v] + truth.kappa_min[v]) / 2 * surface.unit(),
                         (truth.kappa_max[v] - truth.kappa_min[v]) / 2 * surface.unit(), 0});
  }
  return all;
}

std::vector<std::uint32_t> within(const TriangleMesh& mesh, std::uint32_t v, double distance)
{
  std::vector<std::uint32_t> found;
  for (std::size_t u = 0; u < mesh.positions.size(); ++u)
    if (squared_norm(mesh.positions[u] - mesh.positions[v]) <= distance * distance) found.push_back(std::uint32_t(u));
  return found;
}

/// The scale, or the convex combination of two neighbouring ones, that is best for the neighbourhood.
Components best_scale(const Candidates& all, std::uint32_t v, const std::vector<std::uint32_t>& near)
{
  constexpr int steps = 4;
  double least = INFINITY;
  Components best{};
  for (std::size_t c = 0; c + 1 < all.count; ++c)
    for (int s = 0; s <= steps; ++s) {
      const double t = double(s) / steps;
      double sum = 0;
      for (const std::uint32_t u : near) sum += kappa_error(between(all.at(u, c), all.at(u, c + 1), t), all.truth[u]);
      if (sum >= least) continue;
      least = sum;
      best = between(all.at(v, c), all.at(v, c + 1), t);
    }
  return best;
}

/// The weights, of sum 1 but of any sign, that have the least squared error over the neighbourhood: mean curvature and
/// deviator have their own.
Components best_mixture(const Candidates& all, std::uint32_t v, const std::vector<std::uint32_t>& near)
{
  const int free = int(all.count) - 1;
  Components result{};
  for (int part = 0; part < 2; ++part) {
    const std::size_t first = part == 0 ? 0 : 1, last = part == 0 ? 1 : 3;
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(free, free);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(free), d(free);
    for (const std::uint32_t u : near)
      for (std::size_t k = first; k < last; ++k) {
        for (int c = 0; c < free; ++c) d[c] = all.at(u, std::size_t(c))[k] - all.at(u, std::size_t(free))[k];
        a += d * d.transpose();
        b += d * (all.truth[u][k] - all.at(u, std::size_t(free))[k]);
      }
    a.diagonal().array() += 1e-12 * (a.trace() + 1e-30);
    const Eigen::VectorXd w = a.ldlt().solve(b);
    for (std::size_t k = first; k < last; ++k) {
      result[k] = all.at(v, std::size_t(free))[k];
      for (int c = 0; c < free; ++c)
        result[k] += w[c] * (all.at(v, std::size_t(c))[k] - all.at(v, std::size_t(free))[k]);
    }
  }
  return result;
}

}  // namespace

void print_oracle_header() { std::puts("shape,meshing,sigma,vertices_around,best_scale,best_mixture"); }

void print_oracle(const Cell& cell, const TruthMesh& truth, const TriangleMesh& noisy)
{
  constexpr double reach = 16;
  const Candidates all = make_candidates(truth, noisy);
  const double distance = reach * Surface(truth.mesh).unit(), unit = Surface(noisy).unit();
  double scale = 0, mixture = 0, around = 0;
  for (const std::uint32_t v : truth.judged) {
    const std::vector<std::uint32_t> near = within(truth.mesh, v, distance);
    const double reference = truth.reference[v] * unit * double(truth.judged.size());
    scale += kappa_error(best_scale(all, v, near), all.truth[v]) / reference;
    mixture += kappa_error(best_mixture(all, v, near), all.truth[v]) / reference;
    around += double(near.size()) / double(truth.judged.size());
  }
  std::printf("%s,%s,%g,%.0f,%.4g,%.4g\n", cell.shape.c_str(), cell.meshing.c_str(), cell.sigma, around, scale,
              mixture);
  std::fflush(stdout);
}

}  // namespace accuracy
