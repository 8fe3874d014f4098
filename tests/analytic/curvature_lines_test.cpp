// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of curvature where they are known: circles on the torus, confocal curves on Monge's ellipsoid.
#include "integral_invariant/features/curvature_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "integral_invariant/curvature.h"
#include "integral_invariant/error.h"
#include "integral_invariant/features/surface_walk.h"
#include "support/feature_shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

constexpr double major = 2, tube = 0.6, pi = 3.14159265358979323846;
const Vec3 axes{2, 1.5, 1};

std::vector<CurvatureLine> lines_of(const TriangleMesh& mesh, const Result& result, const DirectionParameters& p)
{
  Execution execution;
  return trace_curvature_lines(Surface(mesh), curvature_field(result), p, execution);
}

std::vector<DirectionSegment> segments_of(const TriangleMesh& mesh, const Result& result, const DirectionParameters& p)
{
  Execution execution;
  return direction_segments(Surface(mesh), curvature_field(result), p, execution);
}

DirectionParameters family(DirectionFamily which, double spacing = 0)
{
  DirectionParameters p;
  p.maximal = which == DirectionFamily::maximal;
  p.minimal = !p.maximal;
  p.spacing = spacing;
  return p;
}

/// Smallest and largest value of a function along a line.
template <class F>
std::pair<double, double> range_along(const TriangleMesh& mesh, const CurvatureLine& line, const F& f)
{
  std::pair<double, double> range{1e300, -1e300};
  for (const SurfacePoint& p : line.points) {
    const double value = f(interpolate(mesh.positions, p));
    range = {std::min(range.first, value), std::max(range.second, value)};
  }
  return range;
}

double surface_area(const TriangleMesh& mesh)
{
  double area = 0;
  for (const Triangle& t : mesh.triangles)
    area += norm(cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]])) / 2;
  return area;
}

double smallest_distance(const TriangleMesh& mesh, const CurvatureLine& line, const std::vector<Vec3>& places)
{
  double smallest = 1e300;
  for (const SurfacePoint& p : line.points)
    for (const Vec3& place : places) smallest = std::min(smallest, norm(interpolate(mesh.positions, p) - place));
  return smallest;
}

}  // namespace

TEST(DirectionLines, OfTheTorusAreClosedCirclesAroundTheTube)
{
  const TriangleMesh mesh = torus(major, tube, 240, 72);
  const double spacing = 0.2;
  const auto lines = lines_of(mesh, torus_curvature(mesh, major, tube), family(DirectionFamily::maximal, spacing));
  // Between one spacing apart at the outer equator and half of that (where lines end) at the inner one.
  EXPECT_GT(lines.size(), 2 * pi * (major - tube) / spacing);
  std::size_t closed = 0;
  for (const CurvatureLine& line : lines) {
    closed += line.closed;
    const Vec3 first = interpolate(mesh.positions, line.points[0]);
    const double u0 = std::atan2(first.y, first.x);
    const auto [low, high] = range_along(mesh, line, [&](const Vec3& p) {
      return std::remainder(std::atan2(p.y, p.x) - u0, 2 * pi) * std::hypot(p.x, p.y);
    });
    EXPECT_LT(high - low, 0.1 * spacing);
    if (line.closed) { EXPECT_NEAR(line.length, 2 * pi * tube, 0.02 * 2 * pi * tube); }
  }
  EXPECT_GT(closed, 0.5 * double(lines.size()));
}

TEST(DirectionLines, OfTheTorusAreParallelsAroundTheAxis)
{
  const TriangleMesh mesh = torus(major, tube, 240, 72);
  const double spacing = 0.2;
  const auto lines = lines_of(mesh, torus_curvature(mesh, major, tube), family(DirectionFamily::minimal, spacing));
  EXPECT_GT(lines.size(), 2 * pi * tube / spacing * 0.6);
  EXPECT_LT(lines.size(), 2 * pi * tube / spacing * 1.3);
  for (const CurvatureLine& line : lines) {
    EXPECT_TRUE(line.closed);
    const auto [low, high] = range_along(mesh, line, [&](const Vec3& p) { return p.z; });
    EXPECT_LT(high - low, 0.1 * spacing);
  }
}

TEST(DirectionLines, OfMongesEllipsoidKeepTheirConfocalCoordinateAndEndAtTheUmbilics)
{
  const TriangleMesh mesh = ellipsoid(5, axes);
  const double spacing = 0.15, edge = average_edge_length(mesh);
  const auto umbilics = ellipsoid_umbilics(axes);
  const double area = surface_area(mesh);
  for (const auto which : {DirectionFamily::maximal, DirectionFamily::minimal}) {
    DirectionParameters p = family(which, spacing);
    p.umbilic = 0.03;
    p.smoothing_passes = 0;
    const auto lines = lines_of(mesh, ellipsoid_curvature(mesh, axes), p);
    EXPECT_GT(lines.size(), 10u);
    std::vector<int> ends_at(4, 0);
    double worst = 0, total = 0;
    for (const CurvatureLine& line : lines) {
      const auto [low, high] = range_along(mesh, line, [&](const Vec3& q) {
        const Confocal c = confocal_coordinates(q, axes);
        return which == DirectionFamily::maximal ? std::sqrt(c.nu - axes.y * axes.y)
                                                 : std::sqrt(axes.y * axes.y - c.mu);
      });
      const double width = which == DirectionFamily::maximal ? std::sqrt(axes.x * axes.x - axes.y * axes.y)
                                                             : std::sqrt(axes.y * axes.y - axes.z * axes.z);
      worst = std::max(worst, (high - low) / width);
      total += line.length;
      for (const auto& [end, point] :
           {std::pair{line.begins, line.points.front()}, std::pair{line.ends, line.points.back()}})
        if (end == LineEnd::umbilic) {
          double nearest = 1e300;
          for (int u = 0; u < 4; ++u) {
            const double distance = norm(interpolate(mesh.positions, point) - umbilics[u]);
            nearest = std::min(nearest, distance);
            ends_at[u] += distance < 4 * edge;
          }
          EXPECT_LT(nearest, 4 * edge);
        }
    }
    EXPECT_LT(worst, 0.03);
    for (const int ends : ends_at) EXPECT_GE(ends, 1);
    // Lines at the spacing have area / spacing together; those nearer (down to half of it) make it more.
    EXPECT_GT(total, 0.9 * area / spacing);
    EXPECT_LT(total, 1.5 * area / spacing);
  }
}

TEST(DirectionLines, KeepTheirDistance)
{
  const TriangleMesh mesh = ellipsoid(5, axes);
  const double spacing = 0.2;
  const auto lines = lines_of(mesh, ellipsoid_curvature(mesh, axes), family(DirectionFamily::maximal, spacing));
  double smallest = 1e300;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      std::vector<Vec3> places;
      for (const SurfacePoint& p : lines[j].points) places.push_back(interpolate(mesh.positions, p));
      smallest = std::min(smallest, smallest_distance(mesh, lines[i], places));
    }
  EXPECT_GT(smallest, 0.4 * spacing);
}

TEST(DirectionLines, SurviveNoise)
{
  const TriangleMesh clean = torus(major, tube, 240, 72);
  const double edge = average_edge_length(clean);
  const TriangleMesh mesh = with_normal_noise(clean, 0.1 * edge);
  Parameters parameters;
  parameters.r_min = 4 * edge;
  const auto lines = lines_of(mesh, compute_curvature(mesh, parameters), family(DirectionFamily::minimal, 0.25));
  std::size_t closed = 0;
  double worst = 0;
  for (const CurvatureLine& line : lines) {
    closed += line.closed;
    const auto [low, high] = range_along(mesh, line, [&](const Vec3& p) { return p.z; });
    worst = std::max(worst, high - low);
  }
  EXPECT_GT(closed, 0.8 * double(lines.size()));
  EXPECT_LT(worst, 0.1);
}

TEST(DirectionLines, SpheresHaveNone)
{
  const TriangleMesh mesh = icosphere(4, 1);
  Result result = ellipsoid_curvature(mesh, {1, 1, 1});
  EXPECT_TRUE(lines_of(mesh, result, family(DirectionFamily::maximal)).empty());
  EXPECT_TRUE(segments_of(mesh, result, {}).empty());
}

TEST(DirectionLines, EndAtBoundaries)
{
  TriangleMesh mesh = torus(major, tube, 240, 72);
  const Result result = torus_curvature(mesh, major, tube);
  mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(),
                                      [&](const Triangle& t) { return mesh.positions[t[0]].z < 0; }),
                       mesh.triangles.end());
  const auto lines = lines_of(mesh, result, family(DirectionFamily::maximal, 0.2));
  EXPECT_GT(lines.size(), 20u);
  std::size_t at_boundary = 0;
  for (const CurvatureLine& line : lines) {
    at_boundary += (line.begins == LineEnd::boundary) + (line.ends == LineEnd::boundary);
    EXPECT_LT(line.length, 1.1 * pi * tube);
  }
  EXPECT_GT(at_boundary, 1.5 * double(lines.size()));
}

TEST(DirectionLines, SegmentsAreEvenlySpacedTangentAndOfTheAskedLength)
{
  const TriangleMesh mesh = torus(major, tube, 240, 72);
  DirectionParameters p;
  p.minimal = true;
  p.spacing = 0.3;
  p.segment_length = 0.2;
  const Result result = torus_curvature(mesh, major, tube);
  const auto segments = segments_of(mesh, result, p);
  const double area = 4 * pi * pi * major * tube;
  EXPECT_GT(segments.size(), 2 * area / (1.4 * 0.3 * 0.3));
  for (const DirectionSegment& s : segments) {
    EXPECT_NEAR(norm(s.half), 0.1, 1e-12);
    EXPECT_NEAR(dot(s.half, result.normal[s.vertex]), 0, 1e-12);
    for (const DirectionSegment& t : segments)
      if (t.vertex != s.vertex) { ASSERT_GT(norm(mesh.positions[s.vertex] - mesh.positions[t.vertex]), 0.299); }
  }
}

TEST(DirectionLines, LengthsOutOfRangeAreRefusedByName)
{
  const TriangleMesh mesh = torus(major, tube, 40, 12);
  const Result result = torus_curvature(mesh, major, tube);
  for (const double spacing : {1e-300, -1.0, 1e300, HUGE_VAL, std::nan("")}) {
    const DirectionParameters p = family(DirectionFamily::maximal, spacing);
    for (const bool traced : {true, false}) try {
        if (traced)
          lines_of(mesh, result, p);
        else
          segments_of(mesh, result, p);
        ADD_FAILURE() << spacing;
      } catch (const ParameterError& e) {
        EXPECT_NE(std::string(e.what()).find("'spacing'"), std::string::npos) << e.what();
      }
  }
}

TEST(DirectionLines, LinesThatWouldNotFitIntoMemoryAreRefused)
{
  const TriangleMesh mesh = torus(major, tube, 40, 12);
  DirectionParameters p = family(DirectionFamily::maximal, 2e-3 * average_edge_length(mesh));
  p.memory_limit_mb = 100;
  EXPECT_THROW(lines_of(mesh, torus_curvature(mesh, major, tube), p), MemoryError);
}

TEST(SurfaceWalk, StaysWhereThereIsNoWayOn)
{
  // A triangle without area has no gradients, so no side is ever reached.
  const TriangleMesh mesh{{{5, 5, 5}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 0}}, {{1, 2, 3}, {1, 2, 4}}};
  const Surface surface(mesh);
  Execution execution(1);
  const Topology topology(surface, execution);
  const std::vector<Vec3> lines(mesh.positions.size(), Vec3{1, 0, 0});
  SurfacePoint inside;
  const WalkState next = SurfaceWalk(surface, topology).along({1, {0.2, 0.3, 0.5}, {1, 0, 0}}, lines, inside);
  EXPECT_FALSE(next.is_on_surface());
  EXPECT_EQ(inside.vertices, (Triangle{1, 2, 4}));
}
