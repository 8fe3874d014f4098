// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "integral_invariant/vec3.h"
#include "peers/peers.h"

namespace peers {

namespace {

using integral_invariant::Vec3;
using Kernel = CGAL::Simple_cartesian<double>;
using Jet = CGAL::Monge_via_jet_fitting<Kernel>;

/// The vertices of a mesh by cubic cells: sorted by cell, found by bisection of rows of cells.
class Cells {
 public:
  Cells(const std::vector<Vec3>& points, double size) : points_(points), size_(size), order_(points.size())
  {
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(), [&](unsigned a, unsigned b) { return key(points_[a]) < key(points_[b]); });
  }

  /// Vertices within `radius`, which must not exceed the cell size.
  void find(const Vec3& p, double radius, std::vector<Kernel::Point_3>& found) const
  {
    found.assign(1, {p.x, p.y, p.z});  // the jet is fitted about the first point
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) {
        const Vec3 low = p + Vec3{dx * size_, dy * size_, -size_}, high = p + Vec3{dx * size_, dy * size_, size_};
        const auto less = [&](unsigned a, const Key& k) { return key(points_[a]) < k; };
        auto it = std::lower_bound(order_.begin(), order_.end(), key(low), less);
        for (; it != order_.end() && !(key(high) < key(points_[*it])); ++it) {
          const Vec3& q = points_[*it];
          const double distance2 = squared_norm(q - p);
          if (distance2 <= radius * radius && distance2 > 0) found.emplace_back(q.x, q.y, q.z);
        }
      }
  }

 private:
  using Key = std::array<int, 3>;
  Key key(const Vec3& p) const
  {
    return {int(std::floor(p.x / size_)), int(std::floor(p.y / size_)), int(std::floor(p.z / size_))};
  }

  const std::vector<Vec3>& points_;
  double size_;
  std::vector<unsigned> order_;
};

}  // namespace

double cgal_jet(const integral_invariant::TriangleMesh& mesh, double radius)
{
  constexpr std::size_t degree = 2, coefficients = 6;
  const Cells cells(mesh.positions, radius);
  std::vector<Kernel::Point_3> points;
  double sum = 0;
  for (const Vec3& p : mesh.positions) {
    cells.find(p, radius, points);
    if (points.size() >= coefficients)
      sum += std::fabs(Jet()(points.begin(), points.end(), degree, degree).principal_curvatures(0));
  }
  return sum / double(mesh.positions.size());
}

}  // namespace peers
