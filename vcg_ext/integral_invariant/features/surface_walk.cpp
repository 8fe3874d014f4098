// SPDX-License-Identifier: GPL-3.0-or-later
// Walking over triangles. Cost: O(1) a triangle.
#include "integral_invariant/features/surface_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace integral_invariant {

namespace {

/// Nearer to a vertex than this (as weight), the walk goes through the vertex: no side can be told from the other
/// there.
constexpr double vertex_weight = 1 - 1e-5;
/// How far (as weight) from a vertex the walk goes on behind it.
constexpr double behind_vertex = 1e-3;
/// Triangles that a straight way of some edges leads through; among triangles without width it could go round for ever.
constexpr int most_crossings = 10000;

void normalise(std::array<double, 3>& weights)
{
  double sum = 0;
  for (double& w : weights) sum += w = std::max(w, 0.0);
  for (double& w : weights) w /= sum;
}

}  // namespace

Vec3 aligned_direction(const SurfacePoint& point, const std::vector<Vec3>& lines, const Vec3& like)
{
  Vec3 sum;
  for (int i = 0; i < 3; ++i) {
    const Vec3& line = lines[point.vertices[i]];
    sum += line * (dot(line, like) < 0 ? -point.weights[i] : point.weights[i]);
  }
  return sum;
}

bool is_singular(const Triangle& t, const std::vector<Vec3>& lines)
{
  const Vec3 &a = lines[t[0]], &b = lines[t[1]], &c = lines[t[2]];
  return (dot(a, b) < 0) ^ (dot(b, c) < 0) ^ (dot(c, a) < 0);
}

SurfaceWalk::Exit SurfaceWalk::exit_of(const WalkState& state, const TriangleFrame& frame) const
{
  Exit exit{std::numeric_limits<double>::infinity(), -1};
  for (int i = 0; i < 3; ++i) {
    const double rate = dot(frame.gradient[i], state.direction);
    const double distance = -state.weights[i] / rate;
    if (rate < 0 && distance < exit.distance) exit = {std::max(distance, 0.0), i};
  }
  return exit;
}

std::array<double, 3> SurfaceWalk::advanced(const WalkState& state, const TriangleFrame& frame, double distance) const
{
  std::array<double, 3> weights = state.weights;
  for (int i = 0; i < 3; ++i) weights[i] += distance * dot(frame.gradient[i], state.direction);
  normalise(weights);
  return weights;
}

Vec3 SurfaceWalk::direction_at(const WalkState& state, const TriangleFrame& frame, const std::vector<Vec3>& lines) const
{
  return normalized(frame.tangential(aligned_direction(point(state), lines, state.direction)), state.direction);
}

WalkState SurfaceWalk::across(const WalkState& state, int corner) const
{
  const int side = (corner + 1) % 3;
  const std::int32_t next = topology_.across[state.triangle][side];
  if (next < 0) return {};
  const Triangle &from = surface_.triangles()[state.triangle], &to = surface_.triangles()[next];
  const std::int32_t a = from[side], b = from[(side + 1) % 3];
  const Vec3 edge = normalized(surface_.positions()[b] - surface_.positions()[a]);

  WalkState on{next, {}, {}};
  Vec3 opposite;
  for (int i = 0; i < 3; ++i) {
    if (to[i] == a)
      on.weights[i] = state.weights[side];
    else if (to[i] == b)
      on.weights[i] = state.weights[(side + 1) % 3];
    else
      opposite = surface_.positions()[to[i]];
  }
  const Vec3 towards = opposite - surface_.positions()[a];
  const Vec3 inward = normalized(towards - edge * dot(towards, edge), state.direction);
  const double along = std::clamp(dot(state.direction, edge), -1.0, 1.0);
  on.direction = edge * along + inward * std::sqrt(1 - along * along);
  normalise(on.weights);
  return on;
}

WalkState SurfaceWalk::from_vertex(std::int32_t vertex, const Vec3& direction) const
{
  WalkState best;
  double best_score = -0.2;  // further outside than that, the direction leads over a boundary
  const Buckets<std::uint32_t>& around = topology_.around;
  for (auto it = around.begin(std::size_t(vertex)); it != around.end(std::size_t(vertex)); ++it) {
    const std::int32_t triangle = std::int32_t(*it);
    const Triangle& t = surface_.triangles()[triangle];
    const TriangleFrame plane = frame(triangle);
    const int corner = int(std::find(t.begin(), t.end(), vertex) - t.begin());
    const Vec3 flat = normalized(plane.tangential(direction), direction);
    const double b = dot(plane.gradient[(corner + 1) % 3], flat), c = dot(plane.gradient[(corner + 2) % 3], flat);
    const double size = std::abs(b) + std::abs(c), score = size > 0 ? std::min(b, c) / size : -1;
    if (score <= best_score) continue;
    best_score = score;
    best = {triangle, {}, flat};
    best.weights[corner] = 1 - behind_vertex;
    best.weights[(corner + 1) % 3] = behind_vertex * std::max(b, 0.0) / size;
    best.weights[(corner + 2) % 3] = behind_vertex * std::max(c, 0.0) / size;
    normalise(best.weights);
  }
  return best;
}

WalkState SurfaceWalk::straight(WalkState state, double distance) const
{
  for (int crossed = 0; state.is_on_surface(); ++crossed) {
    if (crossed == most_crossings) return {};
    const TriangleFrame plane = frame(state.triangle);
    const Exit exit = exit_of(state, plane);
    if (exit.corner < 0 || exit.distance >= distance) {
      state.weights = advanced(state, plane, exit.corner < 0 ? 0 : distance);
      return state;
    }
    state.weights = advanced(state, plane, exit.distance);
    distance -= exit.distance;
    const auto largest = std::max_element(state.weights.begin(), state.weights.end());
    if (*largest > vertex_weight)
      state = from_vertex(surface_.triangles()[state.triangle][largest - state.weights.begin()], state.direction);
    else
      state = across(state, exit.corner);
    if (distance <= 0) return state;
  }
  return state;
}

WalkState SurfaceWalk::along(const WalkState& start, const std::vector<Vec3>& lines, SurfacePoint& inside) const
{
  const TriangleFrame plane = frame(start.triangle);
  inside = point(start);  // where there is no way on
  WalkState state = start;
  state.direction = direction_at(start, plane, lines);
  const Exit guess = exit_of(state, plane);
  if (guess.corner < 0) return {};
  WalkState middle = state;
  middle.weights = advanced(state, plane, guess.distance / 2);
  const Vec3 halfway = direction_at(middle, plane, lines);
  const Vec3 initial = state.direction;
  state.direction = halfway;
  Exit exit = exit_of(state, plane);
  if (exit.distance <= 0 && guess.distance > 0) {
    state.direction = initial;
    exit = guess;
  }
  if (exit.distance <= 0) {
    // The field leads back over the side just crossed: it runs along it. Go to the end of the side that it points to.
    std::int32_t vertex = -1;
    double best = 0;
    for (int i = 0; i < 3; ++i) {
      if (i == exit.corner) continue;
      const std::int32_t v = surface_.triangles()[state.triangle][i];
      const double ahead = dot(surface_.positions()[v] - position(state), state.direction);
      if (ahead > best) {
        best = ahead;
        vertex = v;
      }
    }
    if (vertex < 0) return {};
    inside = {{vertex, vertex, vertex}, {1, 0, 0}};
    return from_vertex(vertex, normalized(aligned_direction(inside, lines, state.direction), state.direction));
  }
  state.weights = advanced(state, plane, exit.distance);
  inside = point(state);
  const auto largest = std::max_element(state.weights.begin(), state.weights.end());
  if (*largest > vertex_weight)
    return from_vertex(surface_.triangles()[state.triangle][largest - state.weights.begin()], state.direction);
  return across(state, exit.corner);
}

}  // namespace integral_invariant
