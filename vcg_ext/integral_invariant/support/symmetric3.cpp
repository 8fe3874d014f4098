// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenvectors of symmetric 3x3 matrices. The only file that knows Eigen's solver.
#include "integral_invariant/support/symmetric3.h"

#include <Eigen/Eigenvalues>

namespace integral_invariant {

EigenDecomposition3 eigen_decomposition(const Symmetric3& s)
{
  Eigen::Matrix3d m;
  m << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
  EigenDecomposition3 result;
  for (int i = 0; i < 3; ++i) {
    const auto v = solver.eigenvectors().col(i);
    result.values[i] = solver.eigenvalues()(i);
    result.vectors[i] = {v(0), v(1), v(2)};
  }
  return result;
}

namespace {

/// Adjugate of s − shift·I: its columns span the eigenspace of an eigenvalue equal to shift, so that applying it is
/// a step of inverse iteration that needs no division and stays finite at the eigenvalue itself.
Symmetric3 adjugate_of_shifted(const Symmetric3& s, double shift)
{
  const double a = s.xx - shift, b = s.yy - shift, c = s.zz - shift;
  return {b * c - s.yz * s.yz, s.xz * s.yz - s.xy * c, s.xy * s.yz - s.xz * b,
          a * c - s.xz * s.xz, s.xy * s.xz - s.yz * a, a * b - s.xy * s.xy};
}

Vec3 best_aligned(const Symmetric3& s, const Vec3& guess)
{
  const EigenDecomposition3 eigen = eigen_decomposition(s);
  Vec3 best = eigen.vectors[0];
  for (const Vec3& v : eigen.vectors)
    if (std::abs(dot(v, guess)) > std::abs(dot(best, guess))) best = v;
  return dot(best, guess) < 0 ? -best : best;
}

}  // namespace

Vec3 eigenvector_along(const Symmetric3& s, const Vec3& guess)
{
  constexpr int max_steps = 6;            // convergence is cubic; two or three steps are usual
  constexpr double converged = 1e-14;     // squared change of a unit vector: the next one would be its cube
  constexpr double surely_best = 0.7072;  // > 1/sqrt(2): no orthogonal vector is better aligned

  Vec3 v = guess;
  for (int step = 0; step < max_steps; ++step) {
    Vec3 next = adjugate_of_shifted(s, quadratic_form(s, v)) * v;
    const double length = norm(next);
    if (!(length > 0) || !std::isfinite(length)) break;
    next *= (dot(next, v) < 0 ? -1 : 1) / length;
    const double change = squared_norm(next - v);
    v = next;
    if (change < converged) {
      if (dot(v, guess) > surely_best) return v;
      break;
    }
  }
  return best_aligned(s, guess);
}

}  // namespace integral_invariant
