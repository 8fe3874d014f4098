// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: the tensors of all vertices and scales, and their blend at any radius. In: curvature tensors per scale.
// Out: a tensor per vertex and radius. Cost: O(1) a call, about 30 ns. Source: [Lai09 4.1]; why tensors:
// docs/published.md.
#include "integral_invariant/ball_curvature/tensor_field.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

TensorField::TensorField(std::size_t vertices, std::vector<double> radii)
    : vertices_(vertices), radii_(std::move(radii)), entries_(vertices * radii_.size())
{
  const std::size_t n = radii_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double gap = n == 1 ? 1 : (i + 1 < n ? radii_[i + 1] - radii_[i] : radii_[i] - radii_[i - 1]);
    inverse_sigma_.push_back(2 / gap);
  }
}

void TensorField::set(std::size_t vertex, int scale, const CurvatureTensor& tensor)
{
  const Symmetric3& k = tensor.k;
  const Vec3& n = tensor.normal;
  entries_[vertex * radii_.size() + scale] = {
      {float(k.xx), float(k.xy), float(k.xz), float(k.yy), float(k.yz), float(k.zz)},
      {float(n.x), float(n.y), float(n.z)},
      float(tensor.confidence)};
}

CurvatureTensor TensorField::at_scale(std::size_t vertex, int scale) const
{
  const Entry& e = entries_[vertex * radii_.size() + scale];
  return {{e.k[0], e.k[1], e.k[2], e.k[3], e.k[4], e.k[5]},
          normalized({e.normal[0], e.normal[1], e.normal[2]}),
          e.confidence};
}

TensorField::Weights TensorField::weights_at(double r) const
{
  // With σ half the gap, a scale two gaps away weighs e^-16 ~ 1e-7 of the nearest: at most five scales matter.
  const int n = int(radii_.size());
  r = std::clamp(r, radii_.front(), radii_.back());
  const int above = int(std::lower_bound(radii_.begin(), radii_.end(), r) - radii_.begin());
  const int nearest = above > 0 && r - radii_[above - 1] < radii_[above] - r ? above - 1 : above;
  Weights w;
  w.first = std::max(0, nearest - 2);
  w.count = std::min(n - 1, nearest + 2) - w.first + 1;

  // Relative to the nearest scale, so that the sum is at least 1 whatever the spacing.
  const auto exponent = [&](int i) { return (r - radii_[i]) * inverse_sigma_[i]; };
  const double lowest = exponent(nearest) * exponent(nearest);
  double sum = 0;
  for (int j = 0; j < w.count; ++j) {
    const double t = exponent(w.first + j);
    sum += w.value[j] = std::exp(lowest - t * t);
  }
  for (int j = 0; j < w.count; ++j) w.value[j] /= sum;
  return w;
}

CurvatureTensor TensorField::at_radius(std::size_t vertex, double r) const
{
  if (radii_.size() == 1) return at_scale(vertex, 0);
  const Weights w = weights_at(r);
  const Entry* entries = &entries_[vertex * radii_.size() + w.first];
  double k[6] = {}, n[3] = {}, confidence = 0;
  for (int j = 0; j < w.count; ++j) {
    for (int c = 0; c < 6; ++c) k[c] += w.value[j] * entries[j].k[c];
    for (int c = 0; c < 3; ++c) n[c] += w.value[j] * entries[j].normal[c];
    confidence += w.value[j] * entries[j].confidence;
  }
  return {{k[0], k[1], k[2], k[3], k[4], k[5]}, normalized({n[0], n[1], n[2]}), confidence};
}

std::size_t TensorField::bytes_per_vertex(std::size_t scales) { return scales * sizeof(Entry); }

}  // namespace integral_invariant
