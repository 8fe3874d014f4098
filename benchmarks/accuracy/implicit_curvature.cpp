// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit_curvature.h"

#include <array>
#include <cmath>

#include "integral_invariant/ball_curvature/curvature_tensor.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

// Differences of fourth order at −2h, −h, 0, h, 2h.
constexpr std::array<double, 5> first_weights{1.0 / 12, -8.0 / 12, 0, 8.0 / 12, -1.0 / 12};
constexpr std::array<double, 5> second_weights{-1.0 / 12, 16.0 / 12, -30.0 / 12, 16.0 / 12, -1.0 / 12};
constexpr std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

double along(const Implicit& f, const Vec3& p, const Vec3& step, const std::array<double, 5>& weights)
{
  double sum = 0;
  for (int i = 0; i < 5; ++i)
    if (weights[i] != 0) sum += weights[i] * f(p + step * (i - 2));
  return sum;
}

double mixed(const Implicit& f, const Vec3& p, const Vec3& a, const Vec3& b)
{
  double sum = 0;
  for (int i = 0; i < 5; ++i)
    if (first_weights[i] != 0) sum += first_weights[i] * along(f, p + a * (i - 2), b, first_weights);
  return sum;
}

}  // namespace

void measure_truth(TruthMesh& truth, const Implicit& f, double h)
{
  for (const Vec3& p : truth.mesh.positions) {
    const Vec3 x = axes[0] * h, y = axes[1] * h, z = axes[2] * h;
    const Vec3 gradient =
        Vec3{along(f, p, x, first_weights), along(f, p, y, first_weights), along(f, p, z, first_weights)} * (1 / h);
    const Symmetric3 hessian =
        Symmetric3{along(f, p, x, second_weights), mixed(f, p, x, y), mixed(f, p, x, z),
                   along(f, p, y, second_weights), mixed(f, p, y, z), along(f, p, z, second_weights)} *
        (1 / (h * h));
    const CurvatureTensor tensor{hessian * (1 / norm(gradient)), normalized(gradient), 1};
    const PrincipalCurvatures principal = principal_curvatures(tensor);
    truth.normal.push_back(tensor.normal);
    truth.kappa_max.push_back(principal.kappa_max);
    truth.kappa_min.push_back(principal.kappa_min);
    truth.dir_max.push_back(principal.dir_max);
  }
  set_reference(truth, 0, truth.mesh.positions.size());
}

}  // namespace accuracy
