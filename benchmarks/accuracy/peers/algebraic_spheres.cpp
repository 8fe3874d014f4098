// SPDX-License-Identifier: GPL-3.0-or-later
// Algebraic point set surfaces [Guennebaud, Gross: Algebraic point set surfaces, 2007; Dynamic sampling and rendering
// of algebraic point set surfaces, 2008], as Ponca has them, written from the papers: spheres fitted to points and
// their normals by moving least squares, curvature from the derivative of the surface's normal.
#include <Eigen/Dense>

#include <cmath>

#include "peers/peer.h"
#include "point_cells.h"
#include "support/shapes.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

/// u0 + ⟨u, y⟩ + u4 |y|² with y = x − centre.
struct AlgebraicSphere {
  Vec3 centre, linear;
  double constant = 0, quadratic = 0;

  double value(const Vec3& x) const
  {
    const Vec3 y = x - centre;
    return constant + dot(linear, y) + quadratic * squared_norm(y);
  }
  Vec3 gradient(const Vec3& x) const { return linear + (x - centre) * (2 * quadratic); }
};

class AlgebraicSpheres : public Peer {
 public:
  explicit AlgebraicSpheres(const TriangleMesh& mesh)
      : mesh_(mesh),
        edge_(test_support::average_edge_length(mesh)),
        normal_(test_support::vertex_normals(mesh)),
        cells_(mesh.positions, 3 * edge_)
  {
  }
  std::string name() const override { return "algebraic_spheres"; }
  bool takes_radius() const override { return true; }
  std::vector<Estimate> estimate(const std::vector<std::uint32_t>& vertices, const std::vector<Vec3>& normals,
                                 double radius) override
  {
    constexpr double least_radius = 2;  // in edges; a smaller ball may hold the vertex alone
    radius = std::max(radius, least_radius * edge_);
    std::vector<Estimate> result;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      result.push_back(at(mesh_.positions[vertices[i]], normals[i], radius));
    return result;
  }

 private:
  AlgebraicSphere fit(const Vec3& centre, double radius) const
  {
    double weights = 0, place_normal = 0, squares = 0;
    Vec3 places, normals;
    cells_.for_each_within(centre, radius, [&](std::uint32_t u, double squared) {
      const double w = std::pow(1 - squared / (radius * radius), 2);
      const Vec3 p = mesh_.positions[u] - centre;
      weights += w;
      places += p * w;
      normals += normal_[u] * w;
      place_normal += w * dot(p, normal_[u]);
      squares += w * squared_norm(p);
    });
    AlgebraicSphere s;
    s.centre = centre;
    if (!(weights > 0)) return s;
    const double spread = squares - squared_norm(places) / weights;
    s.quadratic = spread > 0 ? (place_normal - dot(places, normals) / weights) / (2 * spread) : 0;
    s.linear = (normals - places * (2 * s.quadratic)) * (1 / weights);
    s.constant = -(dot(places, s.linear) + s.quadratic * squares) / weights;
    return s;
  }

  Vec3 projected(Vec3 x, double radius) const
  {
    constexpr int steps = 3;
    for (int i = 0; i < steps; ++i) {
      const AlgebraicSphere s = fit(x, radius);
      const Vec3 g = s.gradient(x);
      if (squared_norm(g) > 0) x -= g * (s.value(x) / squared_norm(g));
    }
    return x;
  }

  Estimate at(const Vec3& vertex, const Vec3& outward, double radius) const
  {
    const double step = 0.02 * radius;  // the field of normals is smooth over a tenth of the radius
    const Vec3 x = projected(vertex, radius), n = normalized(fit(x, radius).gradient(x)), a = any_orthogonal(n);
    const Vec3 frame[2] = {a, cross(n, a)};
    const auto normal_at = [&](const Vec3& y) { return normalized(fit(y, radius).gradient(y)); };
    Eigen::Matrix2d k;
    for (int i = 0; i < 2; ++i) {
      const Vec3 change = normal_at(x + frame[i] * step) - normal_at(x - frame[i] * step);
      for (int j = 0; j < 2; ++j) k(i, j) = dot(change, frame[j]) / (2 * step);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver((k + k.transpose()) / 2);
    const auto direction = [&](int i) {
      return frame[0] * solver.eigenvectors()(0, i) + frame[1] * solver.eigenvectors()(1, i);
    };
    const double side = dot(n, outward) < 0 ? -1 : 1;
    return ordered(side * solver.eigenvalues()(1), side * solver.eigenvalues()(0), direction(1), direction(0));
  }

  const TriangleMesh& mesh_;
  double edge_;
  std::vector<Vec3> normal_;
  PointCells cells_;
};

}  // namespace

void add_algebraic_sphere_peer(const TriangleMesh& mesh, PeerList& peers)
{
  peers.push_back(std::make_unique<AlgebraicSpheres>(mesh));
}

}  // namespace accuracy
