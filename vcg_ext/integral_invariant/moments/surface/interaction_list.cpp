// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: what a block of nearby vertices needs of the mesh, gathered once for all of them.
#include "integral_invariant/moments/surface/interaction_list.h"

#include <algorithm>
#include <numeric>

namespace integral_invariant {

namespace {

Sphere triangle_sphere(const PreparedMesh& order, std::size_t index)
{
  std::array<Sphere, 3> corners;
  for (int i = 0; i < 3; ++i) corners[i].centre = order.points[std::size_t(order.triangles[index][i])];
  return bounding_sphere(corners.data(), 3);
}

Sphere edge_sphere(const PreparedMesh& order, std::size_t index)
{
  const BoundaryEdge& edge = order.boundary_edges[index];
  const Vec3 &a = order.points[edge.from], &b = order.points[edge.to];
  return {(a + b) * 0.5, norm(b - a) * 0.5};
}

}  // namespace

SurfaceTree::SurfaceTree(const Surface& surface, bool merge_dense, Execution& execution)
    : order_(prepare_mesh(surface, merge_dense, execution)),
      triangles_(
          order_.triangles.size(), [&](std::size_t i) { return triangle_sphere(order_, i); }, execution),
      boundary_edges_(
          order_.boundary_edges.size(), [&](std::size_t i) { return edge_sphere(order_, i); }, execution),
      is_border_(order_.points.size(), false)
{
  for (const BoundaryEdge& edge : order_.boundary_edges) is_border_[edge.from] = is_border_[edge.to] = true;
  execution.check();
  sum_moments(execution);
}

void SurfaceTree::sum_moments(Execution& execution)
{
  const auto& levels = triangles_.levels();
  moments_.resize(levels.size());
  for (std::size_t level = 0; level < levels.size(); ++level) {
    resize_in_steps(moments_[level], levels[level].size(), execution);
    parallel_step(levels[level].size(), 1024, execution, [&](std::size_t begin, std::size_t end, int) {
      for (std::size_t node = begin; node < end; ++node)
        moments_[level][node] = level == 0 ? moments_of_leaf(node) : moments_of_children(level, node);
    });
  }
}

SurfaceMultipoles SurfaceTree::moments_of_leaf(std::size_t leaf) const
{
  const Vec3& centre = triangles_.levels()[0][leaf].centre;
  SurfaceMultipoles sum;
  for (std::size_t i = triangles_.item_begin(leaf); i < triangles_.item_end(leaf); ++i) {
    const Triangle& t = order_.triangles[i];
    sum += triangle_multipoles(order_.points[std::size_t(t[0])] - centre, order_.points[std::size_t(t[1])] - centre,
                               order_.points[std::size_t(t[2])] - centre);
  }
  return sum;
}

SurfaceMultipoles SurfaceTree::moments_of_children(std::size_t level, std::size_t node) const
{
  const std::vector<Sphere>& children = triangles_.levels()[level - 1];
  const Vec3& centre = triangles_.levels()[level][node].centre;
  const std::size_t first = node * BoundingTree::fan_out,
                    end = std::min(first + BoundingTree::fan_out, children.size());
  SurfaceMultipoles sum;
  for (std::size_t child = first; child < end; ++child)
    sum += translated(moments_[level - 1][child], children[child].centre - centre);
  return sum;
}

void InteractionList::group_points()
{
  point_groups.clear();
  std::array<Sphere, kernel_lanes> members;
  for (std::size_t begin = 0; begin < point_ids.size(); begin += kernel_lanes) {
    const std::size_t count = std::min(kernel_lanes, point_ids.size() - begin);
    for (std::size_t i = 0; i < count; ++i) members[i].centre = point(std::uint32_t(begin + i));
    const Sphere sphere = bounding_sphere(members.data(), count);
    point_groups.push(sphere.centre, sphere.radius);
  }
  const std::size_t full = point_groups.size() * kernel_lanes;
  point_groups.pad();
  x.resize(full, 0.0);
  y.resize(full, 0.0);
  z.resize(full, 0.0);
}

void InteractionList::connect_points()
{
  neighbour_start.assign(x.size() + 1, 0);
  for (const LocalCorners& t : corners)
    for (int i = 0; i < 3; ++i) neighbour_start[t.ring[i] + 1] += 2;
  std::partial_sum(neighbour_start.begin(), neighbour_start.end(), neighbour_start.begin());
  neighbours.resize(neighbour_start.back());
  std::vector<std::uint32_t> next(neighbour_start.begin(), neighbour_start.end() - 1);
  for (const LocalCorners& t : corners)
    for (int i = 0; i < 3; ++i)
      for (const int other : {i + 1, i + 2}) neighbours[next[t.ring[i]]++] = t.ring[other];
}

InteractionGatherer::InteractionGatherer(const SurfaceTree& tree, const std::vector<double>& radii, double reach,
                                         double small_edge, bool sum_far)
    : tree_(tree), radii_(radii), reach_(reach), small_edge_(small_edge), sum_far_(sum_far), table_(4096, 0)
{
}

const InteractionList& InteractionGatherer::gather(std::size_t begin, std::size_t end)
{
  std::vector<Sphere> points;
  for (std::size_t i = begin; i < end; ++i) points.push_back({tree_.order().points[i], 0});
  block_ = bounding_sphere(points.data(), points.size());
  forget_points();
  local_.centre = block_.centre;
  local_.radius = block_.radius;
  local_.reach = radii_.back();
  local_.corners.clear();
  local_.triangles.clear();
  local_.longest_edges.clear();
  local_.lanes.clear();
  local_.all_small_scale = 0;
  local_.longest_edge = 0;
  local_.leaves.clear();
  local_.leaf_spheres.clear();
  local_.large.clear();
  local_.boundary_edges.clear();
  local_.close_boundary_edges.clear();
  block_begin_ = begin;
  block_end_ = end;
  local_.far.assign(radii_.size(), {});
  local_.has_far.assign(radii_.size(), 0);
  for (std::size_t i = begin; i < end; ++i) local(std::uint32_t(i));
  gather_triangles();
  gather_boundary_edges();
  local_.group_points();
  local_.leaf_spheres.pad();
  if (!sum_far_) local_.connect_points();
  return local_;
}

int InteractionGatherer::common_scale(const Sphere& sphere) const
{
  const double distance = norm(sphere.centre - block_.centre),
               reach = sphere.radius + block_.radius + position_rounding;
  const auto inside_from = std::lower_bound(radii_.begin(), radii_.end(), distance + reach);
  const auto touched_from = std::lower_bound(radii_.begin(), radii_.end(), distance - reach);
  return inside_from == touched_from ? int(inside_from - radii_.begin()) : -1;
}

void InteractionGatherer::gather_triangles()
{
  const std::vector<Triangle>& triangles = tree_.order().triangles;
  tree_.triangles().visit(
      [&](std::size_t level, std::size_t index, const Sphere& sphere) {
        const int scale = common_scale(sphere);
        if (scale == int(radii_.size())) return false;
        if (scale < 0 || !sum_far_) return true;
        local_.far[std::size_t(scale)] += translated(tree_.moments(level, index), sphere.centre - block_.centre);
        local_.has_far[std::size_t(scale)] = 1;
        return false;
      },
      [&](std::size_t leaf) {
        const Sphere& sphere = tree_.triangles().levels()[0][leaf];
        const std::uint32_t begin = std::uint32_t(local_.corners.size());
        for (std::size_t i = tree_.triangles().item_begin(leaf); i < tree_.triangles().item_end(leaf); ++i)
          add_triangle(triangles[i], std::uint8_t(i - tree_.triangles().item_begin(leaf)));
        local_.leaves.push_back({begin, std::uint32_t(local_.corners.size()), std::uint32_t(leaf)});
        local_.leaf_spheres.push(sphere.centre - block_.centre, sphere.radius);
      });
}

void InteractionGatherer::add_triangle(const Triangle& triangle, std::uint8_t lane)
{
  const std::vector<Vec3>& points = tree_.order().points;
  std::array<Vec3, 3> v;
  for (int i = 0; i < 3; ++i) v[i] = points[std::size_t(triangle[i])] - block_.centre;
  const double longest2 = std::max({squared_norm(v[1] - v[0]), squared_norm(v[2] - v[1]), squared_norm(v[0] - v[2])});
  const double longest_edge = std::sqrt(longest2), reach = radii_.back() + block_.radius;
  const Vec3 centroid = (v[0] + v[1] + v[2]) * (1.0 / 3);
  if (squared_norm(centroid) > (reach + longest_edge) * (reach + longest_edge)) return;
  LocalCorners corners;
  for (int i = 0; i < 3; ++i) corners.ring[i] = local(std::uint32_t(triangle[i]));
  corners.ring[3] = corners.ring[0];
  corners.ring[4] = corners.ring[1];
  corners.first_small_scale = first_small_scale(longest_edge);
  if (corners.first_small_scale > 0 &&
      norm(centroid) < radii_[corners.first_small_scale - 1] + block_.radius + longest_edge)
    local_.large.push_back(std::uint32_t(local_.corners.size()));
  local_.all_small_scale = std::max(local_.all_small_scale, corners.first_small_scale);
  local_.longest_edge = std::max(local_.longest_edge, longest_edge);
  const Vec3 area = cross(v[1] - v[0], v[2] - v[0]);
  const Symmetric3 spread = (outer(v[0] - centroid) + outer(v[1] - centroid) + outer(v[2] - centroid)) * (1.0 / 12);
  local_.corners.push_back(corners);
  local_.triangles.push_back({{centroid.x, centroid.y, centroid.z, 1},
                              {area.x, area.y, area.z, 0},
                              {spread.xx, spread.yy, spread.zz, 0},
                              {spread.xy, spread.yz, spread.xz, 0}});
  local_.longest_edges.push_back(longest_edge);
  local_.lanes.push_back(lane);
}

std::uint32_t InteractionGatherer::first_small_scale(double edge) const
{
  std::size_t scale = 0;
  while (scale < radii_.size() && edge > small_edge_ * radii_[scale]) ++scale;
  return std::uint32_t(scale);
}

void InteractionGatherer::gather_boundary_edges()
{
  const auto is_within = [&](const Sphere& sphere, double reach) {
    return norm(sphere.centre - block_.centre) <= reach + block_.radius + sphere.radius;
  };
  near_edges_.clear();
  close_edges_.clear();
  const BoundingTree& tree = tree_.boundary_edges();
  tree.visit([&](std::size_t, std::size_t, const Sphere& sphere) { return is_within(sphere, reach_); },
             [&](std::size_t leaf) {
               for (std::size_t i = tree.item_begin(leaf); i < tree.item_end(leaf); ++i) {
                 const Sphere sphere = edge_sphere(tree_.order(), i);
                 if (!is_within(sphere, reach_)) continue;
                 near_edges_.push_back(std::uint32_t(i));
                 if (is_within(sphere, radii_.back() + position_rounding)) close_edges_.push_back(std::uint32_t(i));
               }
             });
  // Far more than the border of a surface has: triangles that share no edges, or turn over at every other one.
  constexpr std::size_t most_far = 128, most_close = 256, crowd = 512;
  const bool may_thin = small_edge_ > 0;
  local_.is_crowd = may_thin && close_edges_.size() > crowd;
  add_boundary_edges(near_edges_, may_thin ? most_far : near_edges_.size(), local_.boundary_edges);
  add_boundary_edges(close_edges_, may_thin ? most_close : close_edges_.size(), local_.close_boundary_edges);
}

void InteractionGatherer::add_boundary_edges(const std::vector<std::uint32_t>& edges, std::size_t most,
                                             std::vector<LocalBoundaryEdge>& local_edges)
{
  // Where there are more, a sample stands for them, or n of them would cost n² in all.
  const std::size_t stride = edges.empty() ? 1 : (edges.size() + most - 1) / most;
  const auto is_of_block = [&](std::uint32_t point) { return point >= block_begin_ && point < block_end_; };
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const BoundaryEdge& e = tree_.order().boundary_edges[edges[i]];
    const std::uint32_t stands_for = i % stride == 0 ? std::uint32_t(stride) : 0;
    // The ends of the surface at a point of the block must be all there: each that arrives has one that leaves.
    if (stands_for == 0 && !is_of_block(e.from) && !is_of_block(e.to)) continue;
    local_edges.push_back({local(e.from), local(e.to), local(e.opposite), e.surplus, stands_for});
  }
}

std::uint32_t InteractionGatherer::local(std::uint32_t point)
{
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = point & mask;  // ids along the curve are dense: consecutive ones do not collide
  while (table_[slot] != 0) {
    if (local_.point_ids[table_[slot] - 1] == point) return table_[slot] - 1;
    slot = (slot + 1) & mask;
  }
  const Vec3 position = tree_.order().points[point] - block_.centre;
  local_.point_ids.push_back(point);
  local_.x.push_back(position.x);
  local_.y.push_back(position.y);
  local_.z.push_back(position.z);
  table_[slot] = std::uint32_t(local_.point_ids.size());
  if (2 * local_.point_ids.size() > table_.size()) grow_table();
  return std::uint32_t(local_.point_ids.size() - 1);
}

void InteractionGatherer::forget_points()
{
  std::fill(table_.begin(), table_.end(), 0);
  local_.point_ids.clear();
  local_.x.clear();
  local_.y.clear();
  local_.z.clear();
}

void InteractionGatherer::grow_table()
{
  table_.assign(2 * table_.size(), 0);
  const std::size_t mask = table_.size() - 1;
  for (std::size_t i = 0; i < local_.point_ids.size(); ++i) {
    std::size_t slot = local_.point_ids[i] & mask;
    while (table_[slot] != 0) slot = (slot + 1) & mask;
    table_[slot] = std::uint32_t(i + 1);
  }
}

}  // namespace integral_invariant
