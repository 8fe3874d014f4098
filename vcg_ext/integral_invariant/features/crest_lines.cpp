// SPDX-License-Identifier: GPL-3.0-or-later
// Crest lines. In: curvature field. Out: polylines over the edges of the mesh.
// Definition: extrema of a principal curvature along its own direction, as in the literature on crest lines; the field
// is the integral invariants' instead of one fitted to derivatives.
#include "integral_invariant/features/crest_lines.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "integral_invariant/error.h"
#include "integral_invariant/features/crest_linking.h"
#include "integral_invariant/features/surface_walk.h"
#include "integral_invariant/features/topology.h"
#include "integral_invariant/parameters.h"

namespace integral_invariant {

namespace {

/// One kind of line as that of a maximum of `kappa` along `direction`.
struct Profile {
  FeatureKind kind;
  std::vector<double> kappa;  ///< κ_max, or −κ_min for valleys
  std::vector<double> rival;  ///< absolute value of the other curvature
  const std::vector<Vec3>* direction;
  std::vector<double> derivative;  ///< ∂κ/∂direction at the vertices
};

void differentiate(const Surface& surface, Profile& profile, Execution& execution)
{
  const std::size_t n = surface.vertex_count();
  std::vector<Vec3> gradient;
  std::vector<double> area;
  resize_in_steps(gradient, n, execution);
  resize_in_steps(area, n, execution);
  resize_in_steps(profile.derivative, n, execution);
  for_each_in_order(surface.triangles().size(), execution, [&](std::size_t i) {
    const Triangle& t = surface.triangles()[i];
    const TriangleFrame frame(t, surface.positions());
    const Vec3 g =
        frame.gradient_of(profile.kappa[t[0]], profile.kappa[t[1]], profile.kappa[t[2]]) * frame.doubled_area;
    for (const std::int32_t v : t) {
      gradient[v] += g;
      area[v] += frame.doubled_area;
    }
  });
  for_each_index(n, execution, [&](std::size_t v) {
    if (area[v] > 0) profile.derivative[v] = dot(gradient[v], (*profile.direction)[v]) / area[v];
  });
}

Profile make_profile(const Surface& surface, const CurvatureField& field, FeatureKind kind, Execution& execution)
{
  const bool ridge = kind == FeatureKind::ridge;
  Profile profile{kind, field.kappa_max, field.kappa_min, ridge ? &field.dir_max : &field.dir_min, {}};
  if (!ridge) profile.kappa.swap(profile.rival);
  if (!ridge)
    for (double& k : profile.kappa) k = -k;
  for (double& k : profile.rival) k = std::abs(k);
  execution.check();
  differentiate(surface, profile, execution);
  return profile;
}

/// The piece of the line in triangle `t`, if any. Each side asks for a sign change with the directions of its own two
/// ends signed alike, so both triangles of an edge agree; where the three cannot be signed alike (an umbilic) there is
/// none.
CrestSegment segment_in(const Triangle& t, const std::vector<Vec3>& positions, const Profile& profile)
{
  const std::vector<Vec3>& d = *profile.direction;
  std::array<double, 3> sign{1, 1, 1}, e{};
  for (int i = 1; i < 3; ++i) sign[i] = dot(d[t[0]], d[t[i]]) < 0 ? -1 : 1;
  CrestSegment segment;
  if ((dot(d[t[1]], d[t[2]]) < 0) != (sign[1] * sign[2] < 0)) return segment;
  Vec3 direction;
  double kappa = 0, rival = 0;
  for (int i = 0; i < 3; ++i) {
    e[i] = sign[i] * profile.derivative[t[i]];
    direction += d[t[i]] * (sign[i] / 3);
    kappa += profile.kappa[t[i]] / 3;
    rival += profile.rival[t[i]] / 3;
  }
  int found = 0;
  for (int i = 0; i < 3; ++i) {
    // A zero takes the side of its own direction: consistent for all triangles around the vertex.
    const int j = (i + 1) % 3;
    const bool up_i = profile.derivative[t[i]] >= 0 ? sign[i] > 0 : sign[i] < 0;
    const bool up_j = profile.derivative[t[j]] >= 0 ? sign[j] > 0 : sign[j] < 0;
    if (up_i != up_j && found < 2) segment.piece.side[found++] = i;
  }
  if (found < 2) return segment;
  const TriangleFrame frame(t, positions);
  segment.piece.exists = true;
  segment.curvature = kappa;
  const double second = dot(frame.gradient_of(e[0], e[1], e[2]), direction);
  segment.extremum = second < 0 && kappa > rival;
  return segment;
}

/// Where the derivative vanishes on a side, linearly between its ends.
SurfacePoint crossing(const Triangle& t, int side, const Profile& profile)
{
  const std::int32_t a = std::min(t[side], t[(side + 1) % 3]), b = std::max(t[side], t[(side + 1) % 3]);
  const double ea = std::abs(profile.derivative[a]), eb = std::abs(profile.derivative[b]);
  return edge_point(a, b, ea + eb > 0 ? ea / (ea + eb) : 0.5);
}

/// κ at the distance `way` from the middle of triangle `t`, to both sides across the line; the middle where there is no
/// way.
double mean_beside(const SurfaceWalk& walk, std::int32_t t, const SurfacePoint& at, const Profile& profile, double way)
{
  const double here = interpolate(profile.kappa, at);
  const Vec3 across =
      walk.frame(t).tangential(aligned_direction(at, *profile.direction, (*profile.direction)[at.vertices[0]]));
  double sum = 0;
  for (const double side : {1.0, -1.0}) {
    const WalkState end = walk.straight({t, {1.0 / 3, 1.0 / 3, 1.0 / 3}, normalized(across) * side}, way);
    sum += end.is_on_surface() ? interpolate(profile.kappa, walk.point(end)) : here;
  }
  return sum / 2;
}

/// −κ″/κ³ across the line at the middle of triangle `t`.
double sharpness_at(const Surface& surface, const SurfaceWalk& walk, std::int32_t t, const Profile& profile)
{
  constexpr double longest_way = 16;  // ē
  const SurfacePoint middle{surface.triangles()[t], {1.0 / 3, 1.0 / 3, 1.0 / 3}};
  const double kappa = interpolate(profile.kappa, middle);
  if (!(kappa > 0)) return 0;
  const double way = std::min(0.5 / kappa, longest_way), relative_way = way * kappa;
  return 2 * (1 - mean_beside(walk, t, middle, profile, way) / kappa) / (relative_way * relative_way);
}

/// The value up to which half of the weights are.
double weighted_median(std::vector<std::pair<double, double>> values_and_weights)
{
  std::sort(values_and_weights.begin(), values_and_weights.end());
  double half = 0;
  for (const auto& [value, weight] : values_and_weights) half += weight / 2;
  for (const auto& [value, weight] : values_and_weights) {
    half -= weight;
    if (half <= 0) return value;
  }
  return 0;
}

CrestLine measured_line(const Surface& surface, const SurfaceWalk& walk, const Profile& profile,
                        const std::vector<CrestSegment>& segments, const Curve& chain)
{
  CrestLine line;
  line.kind = profile.kind;
  line.closed = chain.closed;
  for (const CurveStep& step : chain.steps)
    line.points.push_back(crossing(surface.triangles()[step.triangle], step.enter, profile));
  if (!chain.closed)
    line.points.push_back(
        crossing(surface.triangles()[chain.steps.back().triangle], chain.steps.back().leave, profile));
  double length = 0;
  std::vector<std::pair<double, double>> sharpness;  // and for how long
  for (std::size_t i = 0; i < chain.steps.size(); ++i) {
    const std::int32_t t = chain.steps[i].triangle;
    const SurfacePoint &a = line.points[i], &b = line.points[(i + 1) % line.points.size()];
    const double ds = norm(interpolate(surface.positions(), b) - interpolate(surface.positions(), a));
    length += ds;
    line.strength += std::max(segments[t].curvature, 0.0) * ds;
    sharpness.emplace_back(sharpness_at(surface, walk, t, profile), ds);
  }
  line.length = length * surface.unit();
  line.sharpness = weighted_median(std::move(sharpness));
  return line;
}

void add_lines(const Surface& surface, const Topology& topology, const Profile& profile, const CrestLineParameters& p,
               Execution& execution, double from, double to, std::vector<CrestLine>& lines)
{
  const std::vector<Triangle>& triangles = surface.triangles();
  std::vector<CrestSegment> segments;
  resize_in_steps(segments, triangles.size(), execution);
  parallel_for(
      triangles.size(), 2048, execution,
      [&](std::size_t begin, std::size_t end, int) {
        for (std::size_t t = begin; t < end; ++t) segments[t] = segment_in(triangles[t], surface.positions(), profile);
      },
      from, to);
  const SurfaceWalk walk(surface, topology);
  const double minimum_length = p.minimum_length > 0 ? p.minimum_length : 5 * surface.unit();
  for (const Curve& chain : link_segments(topology, segments, execution)) {
    execution.report(to);
    CrestLine line = measured_line(surface, walk, profile, segments, chain);
    if (line.length >= minimum_length && line.strength >= p.minimum_strength && line.sharpness >= p.minimum_sharpness)
      lines.push_back(std::move(line));
  }
}

}  // namespace

std::vector<CrestLine> find_crest_lines(const Surface& surface, const CurvatureField& field,
                                        const CrestLineParameters& p, Execution& execution)
{
  if (p.smoothing_passes > limits::max_smoothing_passes)
    throw ParameterError("The parameter 'smoothing_passes' must be at most " +
                         std::to_string(limits::max_smoothing_passes) + ".");
  constexpr double smoothed_by = 0.3, adjacent_by = 0.4;  // fractions of the stage
  const CurvatureField smooth = smoothed(surface, field, p.smoothing_passes, execution, smoothed_by);
  const Topology topology(surface, execution);
  execution.report(adjacent_by);
  std::vector<CrestLine> lines;
  const std::pair<FeatureKind, bool> kinds[] = {{FeatureKind::ridge, p.ridges}, {FeatureKind::valley, p.valleys}};
  double from = adjacent_by;
  for (const auto& [kind, is_wanted] : kinds) {
    const double to = from + (1 - adjacent_by) / 2;
    if (is_wanted) {
      const Profile profile = make_profile(surface, smooth, kind, execution);
      execution.report(from);
      add_lines(surface, topology, profile, p, execution, from, to, lines);
    }
    from = to;
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const CrestLine& a, const CrestLine& b) { return a.strength > b.strength; });
  return lines;
}

}  // namespace integral_invariant
