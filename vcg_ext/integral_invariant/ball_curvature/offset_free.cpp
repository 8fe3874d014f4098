// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: curvature tensor and centre offset from the moments of one ball. In: ball moments (normalised units).
// Out: tensor, normal, offset. Cost: O(1), about 0.1 µs. Source: docs/method.md §3.
#include "integral_invariant/ball_curvature/offset_free.h"

namespace integral_invariant {

OffsetFreeMeasure offset_free_measure(const BallMoments& moments, double r)
{
  const TangentialCovariance covariance = tangential_covariance(moments, r);
  if (!covariance.is_valid) return {};
  const Vec3& n = covariance.normal;
  const double r3 = r * r * r, r6 = r3 * r3;
  const double trace = covariance.tangential.trace();
  const double mean = -(24 / (pi * r6)) * (trace - r * r * moments.volume / 2 + pi / 15 * r3 * r * r);
  const Symmetric3 projector = Symmetric3::identity() - outer(n);
  const Symmetric3 deviator = (covariance.tangential - projector * (trace / 2)) * (-24 / (pi * r6));
  const double offset = (moments.volume - 2 * pi / 3 * r3 + pi / 4 * r3 * r * mean) / (pi * r * r);
  return {{projector * mean + deviator, n, moments.confidence}, offset};
}

}  // namespace integral_invariant
