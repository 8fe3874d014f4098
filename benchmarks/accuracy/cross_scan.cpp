// SPDX-License-Identifier: GPL-3.0-or-later
#include "cross_scan.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <vector>

#include "integral_invariant/curvature.h"
#include "integral_invariant/support/pi.h"
#include "point_cells.h"
#include "support/ply_file.h"
#include "support/shapes.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

struct Scan {
  TriangleMesh mesh;
  double edge = 0;
  std::vector<Vec3> normal;
  std::vector<bool> inner;  ///< at least six edges from a boundary
};

struct Setting {
  std::string name;
  Parameters parameters;  ///< lengths in average edges
};

std::vector<Vec3> boundary_points(const TriangleMesh& mesh)
{
  std::set<std::pair<int, int>> open;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t c = 0; c < 3; ++c)
      if (!open.erase({t[(c + 1) % 3], t[c]})) open.insert({t[c], t[(c + 1) % 3]});
  std::vector<Vec3> points;
  for (const auto& edge : open) points.push_back(mesh.positions[std::size_t(edge.first)]);
  return points;
}

Scan read_scan(const std::string& path)
{
  constexpr double least_boundary_distance = 6;  // edges
  Scan scan;
  scan.mesh = test_support::read_ply(path).mesh();
  scan.edge = test_support::average_edge_length(scan.mesh);
  scan.normal = test_support::vertex_normals(scan.mesh);
  const double distance = least_boundary_distance * scan.edge;
  const PointCells boundary(boundary_points(scan.mesh), distance);
  for (const Vec3& p : scan.mesh.positions) scan.inner.push_back(boundary.nearest(p, distance) == PointCells::none);
  return scan;
}

Setting constant(double radius, Estimator estimator)
{
  char name[40];
  std::snprintf(name, sizeof name, estimator == Estimator::bias_free ? "bias removed, %g ē" : "offset-free, %g ē",
                radius);
  Setting setting{name, {}};
  setting.parameters.radius_choice = RadiusChoice::fixed;
  setting.parameters.estimator = estimator;
  setting.parameters.radius = radius;
  return setting;
}

Result measured(const Scan& scan, Parameters p)
{
  p.radius *= scan.edge;
  return compute_curvature(scan.mesh, p);
}

double mean_curvature(const Result& r, std::size_t v) { return (r.kappa_max[v] + r.kappa_min[v]) / 2; }

struct Pair {
  std::uint32_t a, b;
};

std::vector<Pair> partners(const Scan& a, const Scan& b)
{
  const double least_cosine = std::cos(32 * pi / 180);
  const PointCells cells(b.mesh.positions, b.edge);
  std::vector<Pair> pairs;
  for (std::uint32_t v = 0; v < a.mesh.positions.size(); ++v) {
    if (!a.inner[v]) continue;
    const std::uint32_t u = cells.nearest(a.mesh.positions[v], a.edge);
    if (u != PointCells::none && b.inner[u] && dot(a.normal[v], b.normal[u]) >= least_cosine) pairs.push_back({v, u});
  }
  return pairs;
}

double r_squared(const std::vector<Pair>& pairs, const Result& method, const Result& target)
{
  constexpr double whole = 0.99, kept = 0.995;
  std::vector<std::pair<double, double>> values;  // target, method
  for (const Pair& p : pairs)
    if (target.confidence[p.b] > whole) values.emplace_back(mean_curvature(target, p.b), mean_curvature(method, p.a));
  std::sort(values.begin(), values.end(),
            [](const auto& x, const auto& y) { return std::abs(x.first) < std::abs(y.first); });
  values.resize(std::size_t(kept * double(values.size())));
  double sum = 0, squares = 0, off = 0;
  for (const auto& [t, h] : values) {
    sum += t;
    squares += t * t;
    off += (h - t) * (h - t);
  }
  return 1 - off / (squares - sum * sum / double(values.size()));
}

/// Readings of all scans by one setting.
std::vector<Result> measured(const std::vector<Scan>& scans, const Setting& setting)
{
  std::vector<Result> results;
  for (const Scan& scan : scans) results.push_back(measured(scan, setting.parameters));
  return results;
}

}  // namespace

void print_cross_scan_scores(const std::string& folder)
{
  std::vector<Scan> scans;
  for (const char* name : {"bun000", "bun045", "bun315", "chin"})
    scans.push_back(read_scan(folder + '/' + name + ".ply"));
  const std::vector<Setting> targets{constant(2, Estimator::bias_free), constant(2, Estimator::offset_free),
                                     constant(1.5, Estimator::bias_free), constant(3, Estimator::bias_free)};
  std::vector<Setting> methods{{"default", {}}};
  for (const double radius : {1.5, 2.0, 2.5, 3.0, 4.0, 5.0})
    methods.push_back(constant(radius, Estimator::offset_free));
  for (const double radius : {2.0, 3.0, 4.0}) methods.push_back(constant(radius, Estimator::bias_free));

  std::vector<std::vector<Result>> readings;
  std::printf("| method | ");
  for (const Setting& target : targets) {
    readings.push_back(measured(scans, target));
    std::printf("target: %s | ", target.name.c_str());
  }
  std::puts("\n|---|---|---|---|---|");
  std::vector<std::array<std::size_t, 2>> ordered_pairs;
  std::vector<std::vector<Pair>> pairs;
  for (std::size_t other = 1; other < scans.size(); ++other)
    for (const auto& [a, b] : {std::array{std::size_t(0), other}, std::array{other, std::size_t(0)}}) {
      ordered_pairs.push_back({a, b});
      pairs.push_back(partners(scans[a], scans[b]));
    }
  for (const Setting& method : methods) {
    const std::vector<Result> results = measured(scans, method);
    std::printf("| %s |", method.name.c_str());
    for (const auto& target : readings) {
      double sum = 0;
      for (std::size_t i = 0; i < pairs.size(); ++i)
        sum += r_squared(pairs[i], results[ordered_pairs[i][0]], target[ordered_pairs[i][1]]);
      std::printf(" %.3f |", sum / double(pairs.size()));
    }
    std::puts("");
    std::fflush(stdout);
  }
}

}  // namespace accuracy
