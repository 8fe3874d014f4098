// SPDX-License-Identifier: GPL-3.0-or-later
#include "integral_invariant/support/symmetric3.h"

#include <gtest/gtest.h>

#include <random>

using namespace integral_invariant;

namespace {

Symmetric3 with_eigenvalues(const Vec3& u, const Vec3& v, double a, double b, double c)
{
  return outer(u) * a + outer(v) * b + outer(cross(u, v)) * c;
}

struct Frame {
  Vec3 u, v;
};

Frame random_frame(std::mt19937& generator)
{
  std::normal_distribution<double> gauss;
  const Vec3 u = normalized({gauss(generator), gauss(generator), gauss(generator)});
  const Vec3 w = normalized({gauss(generator), gauss(generator), gauss(generator)});
  return {u, normalized(cross(u, w))};
}

}  // namespace

TEST(Symmetric3, DecompositionReproducesTheMatrix)
{
  std::mt19937 generator(7);
  for (int i = 0; i < 100; ++i) {
    const Frame f = random_frame(generator);
    const EigenDecomposition3 e = eigen_decomposition(with_eigenvalues(f.u, f.v, 3, -1, 2));
    EXPECT_NEAR(e.values[0], -1, 1e-13);
    EXPECT_NEAR(e.values[1], 2, 1e-13);
    EXPECT_NEAR(e.values[2], 3, 1e-13);
    EXPECT_NEAR(std::abs(dot(e.vectors[2], f.u)), 1, 1e-13);
  }
}

TEST(Symmetric3, EigenvectorAlongFindsTheBestAlignedOneWhateverItsRank)
{
  std::mt19937 generator(3);
  std::normal_distribution<double> gauss(0, 0.15);
  for (int i = 0; i < 2000; ++i) {
    const Frame f = random_frame(generator);
    const double own = i % 3 == 0 ? 0.1 : i % 3 == 1 ? 0.45 : 0.9;
    const Symmetric3 s = with_eigenvalues(f.u, f.v, own, 0.4, 0.5);
    const Vec3 guess = normalized(f.u + Vec3{gauss(generator), gauss(generator), gauss(generator)});
    const Vec3 found = eigenvector_along(s, guess);
    EXPECT_NEAR(dot(found, f.u), 1, 1e-12);
  }
}

TEST(Symmetric3, EigenvectorAlongAcceptsAnEigenvectorAndAMultipleOfTheIdentity)
{
  const Vec3 n = normalized({1, 2, 3});
  EXPECT_NEAR(dot(eigenvector_along(with_eigenvalues(n, any_orthogonal(n), 1, 2, 2), n), n), 1, 1e-15);
  EXPECT_NEAR(norm(eigenvector_along(Symmetric3::identity(2), n)), 1, 1e-15);
  EXPECT_NEAR(norm(eigenvector_along(Symmetric3{}, n)), 1, 1e-15);
}
