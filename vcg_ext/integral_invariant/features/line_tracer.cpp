// SPDX-License-Identifier: GPL-3.0-or-later
// Tracing of lines of curvature through the triangles.
#include "integral_invariant/features/line_tracer.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

namespace {

constexpr double too_near = 0.5;     ///< of the spacing: a line ends this near to another one
constexpr double same_place = 0.25;  ///< of the spacing: a line that passes its start this near is closed
constexpr double sampling = 0.25;    ///< of the spacing: between the samples that other lines are held against
constexpr double finest_sampling =
    1.0 / 64;                        ///< of the spacing: nearer samples tell nothing, and crowd where triangles do
constexpr double smallest_loop = 3;  ///< ē
constexpr double most_steps = 200000;

/// A line that keeps its distance from itself crosses a triangle a few times, the more the closer lines may lie.
std::size_t step_limit(std::size_t triangles, double spacing)
{
  return std::size_t(std::min(most_steps, 1000 + 4 * double(triangles) * (1 + 1 / spacing)));
}
/// Around a vertex, or among slivers, steps may lead in a circle: a line ends after so many within the least progress
/// (ē).
constexpr int most_idle_steps = 256;
constexpr double least_progress = 1e-3;

}  // namespace

LineTracer::LineTracer(const Surface& surface, const Topology& topology, const std::vector<Vec3>& lines,
                       const std::vector<double>& clarity, const TracerOptions& options)
    : surface_(surface),
      walk_(surface, topology),
      lines_(lines),
      clarity_(clarity),
      options_(options),
      most_steps_(step_limit(surface.triangles().size(), options.spacing)),
      grid_(options.spacing)
{
}

bool LineTracer::is_umbilic(const WalkState& state) const
{
  const SurfacePoint p = walk_.point(state);
  return interpolate(clarity_, p) < options_.umbilic || is_singular(p.vertices, lines_);
}

bool LineTracer::has_room(const WalkState& seed, double part) const
{
  if (is_umbilic(seed)) return false;
  return !grid_.any_near(walk_.position(seed), walk_.normal(seed), part * options_.spacing,
                         [](const LineSample&) { return true; });
}

/// Whether the step passes the start of the line the same way, beside it at most by `same_place`.
bool LineTracer::closes(const Vec3& from, const Vec3& to, double arc) const
{
  const double before = dot(from - start_, start_direction_), after = dot(to - start_, start_direction_);
  if (arc < smallest_loop || before > 0 || after < 0 || !(after > before)) return false;
  const Vec3 passing = from + (to - from) * (-before / (after - before));
  return norm(passing - start_) < same_place * options_.spacing;
}

bool LineTracer::comes_too_near(const Vec3& position, const WalkState& state, double arc) const
{
  const double limit = too_near * options_.spacing;
  return grid_.any_near(position, walk_.normal(state), limit, [&](const LineSample& sample) {
    if (sample.line != line_) return true;
    if (std::abs(sample.arc - arc) < 3 * limit) return false;
    // Right behind its own start a line is about to close, not to crowd.
    const Vec3 there = sample.position - position;
    const double ahead = dot(there, state.direction);
    const bool about_to_close = std::abs(sample.arc) < 2 * limit && ahead > -limit &&
                                norm(there - state.direction * ahead) < same_place * options_.spacing;
    return !about_to_close;
  });
}

void LineTracer::add_sample(const LineSample& sample)
{
  grid_.add(sample);
  own_samples_.push_back(sample.position);
}

void LineTracer::add_samples(const Vec3& from, const Vec3& to, const Vec3& normal, double arc, double sign)
{
  const double length = norm(to - from);
  unsampled_ += length;
  if (unsampled_ < finest_sampling * options_.spacing) return;
  unsampled_ = 0;
  const int pieces = std::max(1, int(std::ceil(length / (sampling * options_.spacing))));
  for (int i = 1; i <= pieces; ++i) {
    const double t = double(i) / pieces;
    add_sample({from + (to - from) * t, normal, line_, sign * (arc + t * length)});
  }
}

LineTracer::Half LineTracer::half_line(const WalkState& seed, const Vec3& direction, double sign)
{
  Half half;
  WalkState state = seed;
  state.direction = direction;
  Vec3 place = walk_.position(state);
  unsampled_ = 0;
  Vec3 last_progress = place;
  int idle_steps = 0;
  for (std::size_t step = 0; step < most_steps_; ++step) {
    const Vec3 normal = walk_.normal(state);
    SurfacePoint leaving;
    const WalkState next = walk_.along(state, lines_, leaving);
    const Vec3 to = next.is_on_surface() ? walk_.position(next) : interpolate(surface_.positions(), leaving);
    if (sign > 0 && closes(place, to, half.length)) return half.end = LineEnd::loop, half;
    if (next.is_on_surface() && comes_too_near(to, next, sign * half.length))
      return half.end = LineEnd::near_line, half;
    add_samples(place, to, normal, half.length, sign);
    half.length += norm(to - place);
    if (norm(to - last_progress) > least_progress) {
      last_progress = to;
      idle_steps = 0;
    } else if (++idle_steps == most_idle_steps) {
      return half;
    }
    half.points.push_back(leaving);
    half.states.push_back(state);
    if (!next.is_on_surface()) return half.end = LineEnd::boundary, half;
    if (is_umbilic(next)) return half.end = LineEnd::umbilic, half;
    place = to;
    state = next;
  }
  return half;
}

bool LineTracer::trace(const WalkState& seed, CurvatureLine& line)
{
  const SurfacePoint start = walk_.point(seed);
  const TriangleFrame plane = walk_.frame(seed.triangle);
  start_ = walk_.position(seed);
  start_direction_ = normalized(plane.tangential(aligned_direction(start, lines_, lines_[start.vertices[0]])));
  ++line_;
  own_samples_.clear();
  add_sample({start_, plane.normal, line_, 0});

  Half forward = half_line(seed, start_direction_, 1), backward;
  line.family = options_.family;
  line.closed = forward.end == LineEnd::loop;
  if (line.closed)
    backward.end = LineEnd::loop;
  else
    backward = half_line(seed, -start_direction_, -1);

  line.begins = backward.end;
  line.ends = forward.end;
  line.points.assign(backward.points.rbegin(), backward.points.rend());
  line.points.push_back(start);
  line.points.insert(line.points.end(), forward.points.begin(), forward.points.end());
  const double length = polyline_length(line.points, line.closed, surface_.positions());
  line.length = length * surface_.unit();
  last_states_.assign(backward.states.rbegin(), backward.states.rend());
  last_states_.insert(last_states_.end(), forward.states.begin(), forward.states.end());
  const bool is_kept = length >= options_.minimum_length || line.closed;
  if (!is_kept) std::for_each(own_samples_.rbegin(), own_samples_.rend(), [&](const Vec3& p) { grid_.take_back(p); });
  return is_kept;
}

std::vector<WalkState> LineTracer::seeds_beside() const
{
  std::vector<WalkState> seeds;
  Vec3 last{1e300, 0, 0};
  for (const WalkState& state : last_states_) {
    if (norm(walk_.position(state) - last) < options_.spacing) continue;
    last = walk_.position(state);
    for (const double side : {1.0, -1.0}) {
      WalkState start = state;
      start.direction = cross(walk_.normal(state), state.direction) * side;
      // From an edge the way may lead straight out of the triangle: start a little inside.
      for (double& w : start.weights) w = 0.98 * w + 0.02 / 3;
      seeds.push_back(walk_.straight(start, options_.spacing));
    }
  }
  return seeds;
}

}  // namespace integral_invariant
