// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: removal of bias. In: offset-free tensors (normalised units). Out: the same, corrected. Cost: O(1) a tensor,
// O(scales²) a vertex for the extrapolation. Source: docs/method.md §4.
#include "integral_invariant/ball_curvature/ball_bias.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

namespace {

/// The expansions hold for small κr, κδ and δ/r; beyond, noise is taken for curvature, and corrections would amplify
/// it.
constexpr double largest_kr = 0.9;

/// K = mean·P + deviator on the tangent plane; ±half_difference are the deviator's eigenvalues.
struct Split {
  double mean, half_difference;
  Symmetric3 projector, deviator;
};

Split split(const CurvatureTensor& t)
{
  Split s;
  s.projector = Symmetric3::identity() - outer(t.normal);
  s.mean = t.k.trace() / 2;
  s.deviator = t.k - s.projector * s.mean;
  const Symmetric3& d = s.deviator;
  const double squares = d.xx * d.xx + d.yy * d.yy + d.zz * d.zz + 2 * (d.xy * d.xy + d.xz * d.xz + d.yz * d.yz);
  s.half_difference = std::sqrt(squares / 2);
  return s;
}

/// What curvatures mean ± half add to the measured mean and half difference in a ball of radius r.
struct CubicBias {
  double mean, half_difference;
};

CubicBias cubic_bias(double mean, double half, double r)
{
  // k = h + a cos 2φ: averages over φ of k³, of k k₂ (k₂ = h² + a² + 2 h a cos 2φ), and of both times 2 cos 2φ.
  const double h = mean, a = half;
  const double k3 = h * h * h + 1.5 * h * a * a, kk2 = h * h * h + 2 * h * a * a;
  const double k3_cos = 3 * h * h * a + 0.75 * a * a * a, kk2_cos = 3 * h * h * a + a * a * a;
  return {-r * r * (k3 / 2 - kk2 / 4), -1.5 * r * r * (k3_cos / 6 - kk2_cos / 8)};
}

}  // namespace

CurvatureTensor correct_ball_bias(const CurvatureTensor& measured, double r, double offset, double noise_variance)
{
  const Split s = split(measured);
  constexpr double largest_ratio = 0.1, largest_kd = 0.3;
  const double ratio = std::min((offset * offset + noise_variance) / (r * r), largest_ratio);
  double mean = s.mean * (1 + 6 * ratio) - 4 * offset * offset * offset / (r * r * r * r);
  double half = s.half_difference * (1 + 1.5 * ratio);

  const double largest = std::max(std::abs(mean) + half, 1e-30);
  const double shrink = std::min(1.0, largest_kr / (largest * r));
  const CubicBias bias = cubic_bias(mean * shrink, half * shrink, r);
  mean -= bias.mean;
  half -= bias.half_difference;

  const double shift = std::clamp(offset * largest, -largest_kd, largest_kd) / largest;
  const double parallel_mean = mean - shift * (mean * mean + half * half);
  half *= 1 - 2 * shift * mean;
  const double factor = s.half_difference > 0 ? half / s.half_difference : 0;
  return {s.projector * parallel_mean + s.deviator * factor, measured.normal, measured.confidence};
}

CurvatureTensor correct_jet_bias(const CurvatureTensor& measured, double r)
{
  const Split s = split(measured);
  const double largest = std::max(std::abs(s.mean) + s.half_difference, 1e-30);
  const double shrink = std::min(1.0, largest_kr / (largest * r));
  const double h = s.mean * shrink, a = s.half_difference * shrink;
  const double mean = s.mean - r * r / 4 * (h * h * h + 2 * h * a * a);
  const double half = s.half_difference - 3 * r * r / 16 * (3 * h * h * a + a * a * a);
  const double factor = s.half_difference > 0 ? half / s.half_difference : 0;
  return {s.projector * mean + s.deviator * factor, measured.normal, measured.confidence};
}

void extrapolate_to_zero_radius(TensorField& tensors, Execution& execution)
{
  const std::vector<double>& radii = tensors.radii();
  const int n = int(radii.size());
  // Differences between neighbouring scales are independent: slope ĉ = Σ D_j g_j/N_j / Σ g_j²/N_j over j < i, with
  // D_j = K_j − K_{j+1}, mean c g_j and variance N_j.
  std::vector<double> gap(n), weight(n);
  for (int j = 0; j + 1 < n; ++j) {
    gap[j] = radii[j] * radii[j] - radii[j + 1] * radii[j + 1];
    weight[j] = gap[j] / (std::pow(radii[j], -6) - std::pow(radii[j + 1], -6));
  }
  parallel_for(tensors.vertex_count(), 2048, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t v = begin; v < end; ++v) {
      Symmetric3 numerator;
      double denominator = 0;
      CurvatureTensor here = tensors.at_scale(v, 0);
      for (int i = 1; i < n; ++i) {
        const CurvatureTensor next = tensors.at_scale(v, i);
        numerator += (here.k - next.k) * weight[i - 1];
        denominator += gap[i - 1] * weight[i - 1];
        here = next;
        tensors.set(v, i, {next.k - numerator * (radii[i] * radii[i] / denominator), next.normal, next.confidence});
      }
    }
  });
}

}  // namespace integral_invariant
