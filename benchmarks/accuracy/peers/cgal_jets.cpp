// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "peers/peer.h"

namespace accuracy {

using integral_invariant::norm;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Jet = CGAL::Monge_via_jet_fitting<Kernel>;

/// Finds the vertices near a vertex with a grid of cells.
class Neighbourhoods {
 public:
  Neighbourhoods(const TriangleMesh& mesh, double cell) : points_(mesh.positions), cell_(cell)
  {
    for (std::uint32_t v = 0; v < points_.size(); ++v) cells_[key(points_[v])].push_back(v);
  }

  /// The vertices within `radius` of `v`, `v` first; the radius grows until there are `count`.
  std::vector<std::uint32_t> around(std::uint32_t v, double radius, std::size_t count) const
  {
    for (;; radius *= 1.2) {
      std::vector<std::uint32_t> found = within(v, radius);
      if (found.size() < std::min(count, points_.size())) continue;
      std::swap(found.front(), *std::find(found.begin(), found.end(), v));
      return found;
    }
  }

 private:
  using Key = std::array<int, 3>;

  Key key(const Vec3& p) const
  {
    return {int(std::floor(p.x / cell_)), int(std::floor(p.y / cell_)), int(std::floor(p.z / cell_))};
  }
  std::vector<std::uint32_t> within(std::uint32_t v, double radius) const
  {
    std::vector<std::uint32_t> found;
    const Vec3& p = points_[v];
    const Key low = key(p - Vec3{radius, radius, radius}), high = key(p + Vec3{radius, radius, radius});
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int z = low[2]; z <= high[2]; ++z) {
          const auto it = cells_.find({x, y, z});
          if (it == cells_.end()) continue;
          for (const std::uint32_t u : it->second)
            if (norm(points_[u] - p) <= radius) found.push_back(u);
        }
    return found;
  }

  const std::vector<Vec3>& points_;
  double cell_;
  std::map<Key, std::vector<std::uint32_t>> cells_;
};

class CgalJets : public Peer {
 public:
  CgalJets(const TriangleMesh& mesh, std::shared_ptr<const Neighbourhoods> near, std::size_t degree)
      : mesh_(mesh), near_(std::move(near)), degree_(degree)
  {
  }
  std::string name() const override { return "cgal_jet_" + std::to_string(degree_); }
  bool takes_radius() const override { return true; }
  std::vector<Estimate> estimate(const std::vector<std::uint32_t>& vertices, const std::vector<Vec3>& normals,
                                 double radius) override
  {
    const std::size_t coefficients = (degree_ + 1) * (degree_ + 2) / 2;
    std::vector<Estimate> result;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      std::vector<Kernel::Point_3> points;
      for (const std::uint32_t u : near_->around(vertices[i], radius, coefficients)) {
        const Vec3& p = mesh_.positions[u];
        points.emplace_back(p.x, p.y, p.z);
      }
      Jet::Monge_form form = Jet()(points.begin(), points.end(), degree_, 2);
      form.comply_wrt_given_normal({normals[i].x, normals[i].y, normals[i].z});
      // Heights grow along the outward normal, so a convex solid has negative coefficients.
      result.push_back(ordered(-form.principal_curvatures(1), -form.principal_curvatures(0),
                               vec3(form.minimal_principal_direction()), vec3(form.maximal_principal_direction())));
    }
    return result;
  }

 private:
  static Vec3 vec3(const Kernel::Vector_3& v) { return {v.x(), v.y(), v.z()}; }

  const TriangleMesh& mesh_;
  std::shared_ptr<const Neighbourhoods> near_;
  std::size_t degree_;
};

}  // namespace

void add_cgal_jet_peers(const TriangleMesh& mesh, PeerList& peers)
{
  const Vec3 a = mesh.positions[mesh.triangles[0][0]], b = mesh.positions[mesh.triangles[0][1]];
  const auto near = std::make_shared<const Neighbourhoods>(mesh, 2.5 * norm(b - a));
  for (const std::size_t degree : {2, 3, 4}) peers.push_back(std::make_unique<CgalJets>(mesh, near, degree));
}

}  // namespace accuracy
