// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolated corrected curvature measures [Lachaud, Romon, Thibert, Coeurjolly: Interpolated corrected curvature
// measures for polygonal surfaces, 2020] on normals of fitted planes: what CGAL 5.6 calls
// interpolated_corrected_curvatures, written from the paper's formulas because Debian 12 has CGAL 5.5.
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include "peers/peer.h"
#include "point_cells.h"
#include "support/shapes.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

Eigen::Vector3d eigen(const Vec3& v) { return {v.x, v.y, v.z}; }

/// Sums over the triangles near a vertex, in its tangent frame: μ0, and μ(X, Y) = −area · ⟨Y, dN X⟩ for X, Y of the
/// frame.
struct Measures {
  double area = 0;
  Eigen::Matrix2d tensor = Eigen::Matrix2d::Zero();
};

class CorrectedCurrents : public Peer {
 public:
  /// `share`: radius of the measures divided by that of the planes.
  CorrectedCurrents(const TriangleMesh& mesh, double share)
      : mesh_(mesh),
        share_(share),
        edge_(test_support::average_edge_length(mesh)),
        vertex_normals_(test_support::vertex_normals(mesh)),
        vertices_(mesh.positions, 3 * edge_),
        centres_(centres_of(mesh), 3 * edge_)
  {
  }
  std::string name() const override { return share_ < 1 ? "corrected_currents_half" : "corrected_currents"; }
  bool takes_radius() const override { return true; }
  std::vector<Estimate> estimate(const std::vector<std::uint32_t>& vertices, const std::vector<Vec3>& normals,
                                 double radius) override
  {
    normal_radius_ = std::max(radius, least_radius * edge_);
    known_.assign(mesh_.positions.size(), false);
    normal_.resize(mesh_.positions.size());
    std::vector<Estimate> result;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      result.push_back(at(vertices[i], normals[i], std::max(share_ * radius, least_radius * edge_)));
    return result;
  }

 private:
  static constexpr double least_radius = 1.5;  ///< in edges; fewer points do not determine a plane

  static std::vector<Vec3> centres_of(const TriangleMesh& mesh)
  {
    std::vector<Vec3> centres;
    for (const Triangle& t : mesh.triangles)
      centres.push_back(
          (mesh.positions[std::size_t(t[0])] + mesh.positions[std::size_t(t[1])] + mesh.positions[std::size_t(t[2])]) *
          (1.0 / 3));
    return centres;
  }

  /// Normal of the plane through the vertices within the radius, computed on first use.
  const Vec3& normal_of(std::uint32_t v)
  {
    if (known_[v]) return normal_[v];
    known_[v] = true;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    double count = 0;
    vertices_.for_each_within(mesh_.positions[v], normal_radius_, [&](std::uint32_t u, double) {
      const Eigen::Vector3d p = eigen(mesh_.positions[u] - mesh_.positions[v]);
      sum += p;
      squares += p * p.transpose();
      ++count;
    });
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares - sum * sum.transpose() / count);
    const Eigen::Vector3d n = solver.eigenvectors().col(0);
    normal_[v] = {n.x(), n.y(), n.z()};
    if (dot(normal_[v], vertex_normals_[v]) < 0) normal_[v] = -normal_[v];
    return normal_[v];
  }

  void add_triangle(std::uint32_t face, const Vec3 (&frame)[2], Measures& m)
  {
    const Triangle& t = mesh_.triangles[face];
    const auto place = [&](std::size_t corner) { return mesh_.positions[std::size_t(t[corner])]; };
    const Vec3 ui = normal_of(std::uint32_t(t[0])), uj = normal_of(std::uint32_t(t[1])),
               uk = normal_of(std::uint32_t(t[2]));
    const Vec3 mean = (ui + uj + uk) * (1.0 / 3), ej = place(1) - place(0), ek = place(2) - place(0);
    m.area += dot(mean, cross(ej, ek)) / 2;
    for (int x = 0; x < 2; ++x)
      for (int y = 0; y < 2; ++y)
        m.tensor(x, y) += (dot(frame[y], uk - ui) * dot(mean, cross(frame[x], ej)) -
                           dot(frame[y], uj - ui) * dot(mean, cross(frame[x], ek))) /
                          2;
  }

  Estimate at(std::uint32_t v, const Vec3& outward, double radius)
  {
    const Vec3 n = normal_of(v), a = any_orthogonal(n);
    const Vec3 frame[2] = {a, cross(n, a)};
    Measures m;
    centres_.for_each_within(mesh_.positions[v], radius, [&](std::uint32_t f, double) { add_triangle(f, frame, m); });
    if (m.area == 0) return {};
    const Eigen::Matrix2d k = -(m.tensor + m.tensor.transpose()) / (2 * m.area);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(k);
    const auto direction = [&](int i) {
      return frame[0] * solver.eigenvectors()(0, i) + frame[1] * solver.eigenvectors()(1, i);
    };
    const double side = dot(n, outward) < 0 ? -1 : 1;
    return ordered(side * solver.eigenvalues()(1), side * solver.eigenvalues()(0), direction(1), direction(0));
  }

  const TriangleMesh& mesh_;
  double share_, edge_, normal_radius_ = 0;
  std::vector<Vec3> vertex_normals_;
  PointCells vertices_, centres_;
  std::vector<bool> known_;
  std::vector<Vec3> normal_;
};

}  // namespace

void add_corrected_current_peers(const TriangleMesh& mesh, PeerList& peers)
{
  for (const double share : {1.0, 0.5}) peers.push_back(std::make_unique<CorrectedCurrents>(mesh, share));
}

}  // namespace accuracy
