// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/support/pi.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

double finite(double value) { return std::isfinite(value) ? value : 0; }

/// Angle between two lines in degrees; 45, the mean for a random direction, if one of them is missing.
double angle_between(const Vec3& a, const Vec3& b)
{
  const double sine = norm(cross(a, b)), cosine = std::abs(dot(a, b));
  const double degrees = std::atan2(sine, cosine) * 180 / pi;
  return sine + cosine > 0 && std::isfinite(degrees) ? degrees : 45;
}

double quantile(const std::vector<double>& sorted, double share)
{
  return sorted[std::min(sorted.size() - 1, std::size_t(share * double(sorted.size())))];
}

}  // namespace

Estimate ordered(double first, double second, const Vec3& first_direction, const Vec3& second_direction)
{
  first = finite(first);
  second = finite(second);
  return first >= second ? Estimate{first, second, first_direction, 0} : Estimate{second, first, second_direction, 0};
}

Metrics compare(const TruthMesh& truth, const std::vector<Estimate>& estimates)
{
  Metrics m;
  m.vertices = truth.judged.size();
  std::vector<double> errors;
  double degrees = 0, weights = 0;
  for (std::size_t i = 0; i < m.vertices; ++i) {
    const std::uint32_t v = truth.judged[i];
    const Estimate& e = estimates[i];
    for (const double off : {e.kappa_max - truth.kappa_max[v], e.kappa_min - truth.kappa_min[v]}) {
      errors.push_back(std::abs(off) / truth.reference[v]);
      m.within_one += std::abs(off) <= e.standard_error;
      m.within_two += std::abs(off) <= 2 * e.standard_error;
    }
    // Differences at rounding level (of the truth's own differences) are umbilics: no direction there.
    const double anisotropy = (truth.kappa_max[v] - truth.kappa_min[v]) / truth.reference[v];
    const double weight = anisotropy > 1e-4 ? anisotropy : 0;
    degrees += weight * angle_between(e.dir_max, truth.dir_max[v]);
    weights += weight;
  }
  const double count = double(errors.size());
  for (const double error : errors) {
    m.mean += error / count;
    m.rms += error * error / count;
    m.within_tenth += (error < 0.1) / count;
  }
  m.rms = std::sqrt(m.rms);
  m.within_one /= count;
  m.within_two /= count;
  m.direction = weights > 0 ? degrees / weights : 0;
  std::sort(errors.begin(), errors.end());
  m.median = quantile(errors, 0.5);
  m.p95 = quantile(errors, 0.95);
  m.p99 = quantile(errors, 0.99);
  return m;
}

}  // namespace accuracy
