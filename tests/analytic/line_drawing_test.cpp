// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that have a closed form, from exact curvature fields; and what does not change them.
#include "integral_invariant/drawing/line_drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "integral_invariant/ball_curvature/curvature_tensor.h"
#include "integral_invariant/drawing/view.h"
#include "integral_invariant/error.h"
#include "support/feature_shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

constexpr double pi = 3.14159265358979;

/// A mesh with an exact field, ready to be drawn. Lines come in the unit of the mesh.
class Subject {
 public:
  Subject(const TriangleMesh& mesh, const Result& result, int threads = 0) : execution_(threads), surface_(mesh)
  {
    topology_.emplace(surface_, execution_);
    constexpr double radius = 2;  // ē: exact fields need no width
    const std::vector<double> none(mesh.positions.size(), 0), radii(mesh.positions.size(), radius);
    field_ = differentiate(surface_, {curvature_field(result), none, radii}, execution_);
    shift_ = mesh.positions[0] - surface_.positions()[0] * surface_.unit();
  }

  std::vector<ViewLine> lines(const LineDrawingParameters& p, const View& view)
  {
    const LineDrawing drawing(surface_, *topology_, field_, 0, p, execution_);
    std::vector<ViewLine> lines = drawing.lines_of(view, execution_);
    for (ViewLine& l : lines)
      for (LinePoint& point : l.line.points) point.position = point.position * surface_.unit() + shift_;
    return lines;
  }

 private:
  Execution execution_;
  Surface surface_;
  std::optional<Topology> topology_;
  DifferentiatedField field_;
  Vec3 shift_;
};

LineDrawingParameters none()
{
  LineDrawingParameters p;
  p.contours = p.boundaries = p.creases = p.suggestive_contours = false;
  p.hidden = HiddenLines::dashed;
  return p;
}

LineDrawingParameters contours()
{
  LineDrawingParameters p = none();
  p.contours = true;
  return p;
}

double length_of(const std::vector<ViewLine>& lines)
{
  double sum = 0;
  for (const ViewLine& l : lines) sum += l.line.length();
  return sum;
}

double visible_length_of(const std::vector<ViewLine>& lines)
{
  double sum = 0;
  for (const ViewLine& l : lines) sum += l.visible ? l.line.length() : 0;
  return sum;
}

template <class Distance>
double farthest(const std::vector<ViewLine>& lines, const Distance& distance)
{
  double most = 0;
  for (const ViewLine& l : lines)
    for (const LinePoint& p : l.line.points) most = std::max(most, std::abs(distance(p.position)));
  return most;
}

Result sphere_curvature(const TriangleMesh& mesh) { return ellipsoid_curvature(mesh, {1, 1, 1}); }

/// The graph of a function over the square ±1 with its exact curvature.
struct HeightField {
  TriangleMesh mesh;
  Result result;
};

struct HeightJet {
  double z, x, y, xx, xy, yy;
};

template <class Jet>
HeightField height_field(const Jet& jet_at)
{
  constexpr int half = 40, row = 2 * half + 1;
  HeightField f;
  for (int j = -half; j <= half; ++j)
    for (int i = -half; i <= half; ++i) {
      const double x = double(i) / half, y = double(j) / half;
      const HeightJet jet = jet_at(x, y);
      f.mesh.positions.push_back({x, y, jet.z});
      const Vec3 gradient{-jet.x, -jet.y, 1};
      const Symmetric3 hessian{-jet.xx, -jet.xy, 0, -jet.yy, 0, 0};
      const PrincipalCurvatures k = principal_curvatures({hessian * (1 / norm(gradient)), normalized(gradient), 1});
      f.result.kappa_max.push_back(k.kappa_max);
      f.result.kappa_min.push_back(k.kappa_min);
      f.result.dir_max.push_back(k.dir_max);
      f.result.dir_min.push_back(k.dir_min);
      f.result.normal.push_back(normalized(gradient));
    }
  for (int j = 0; j + 1 < row; ++j)
    for (int i = 0; i + 1 < row; ++i) {
      const int a = j * row + i;
      f.mesh.triangles.push_back({a, a + 1, a + row + 1});
      f.mesh.triangles.push_back({a, a + row + 1, a + row});
    }
  f.result.average_edge = average_edge_length(f.mesh);
  return f;
}

const View from_above = make_view("above", {0, 0, 1}, {0, 1, 0});

}  // namespace

TEST(LineDrawing, TheContourOfASphereIsAGreatCircle)
{
  const TriangleMesh mesh = icosphere(5);
  const Vec3 toward = normalized(Vec3{1, 2, 3});
  const auto lines = Subject(mesh, sphere_curvature(mesh)).lines(contours(), make_view("v", toward, {0, 0, 1}));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].visible);
  EXPECT_TRUE(lines[0].line.closed);
  EXPECT_NEAR(lines[0].line.length(), 2 * pi, 0.002 * 2 * pi);
  EXPECT_LT(farthest(lines, [&](const Vec3& p) { return dot(p, toward); }), 0.05 * average_edge_length(mesh));
}

TEST(LineDrawing, ASphereHasNoOtherLines)
{
  const TriangleMesh mesh = icosphere(5);
  LineDrawingParameters p = none();
  p.boundaries = p.creases = p.suggestive_contours = p.suggestive_highlights = true;
  p.ridges = p.valleys = p.demarcating_curves = p.apparent_ridges = true;
  EXPECT_TRUE(Subject(mesh, sphere_curvature(mesh)).lines(p, make_view("v", {1, 2, 3}, {0, 0, 1})).empty());
}

TEST(LineDrawing, TheContourOfAnEllipsoidIsPlanar)
{
  const Vec3 axes{2, 1.4, 0.8}, v = normalized(Vec3{1, -2, 0.5});
  const TriangleMesh mesh = ellipsoid(5, axes);
  const auto lines = Subject(mesh, ellipsoid_curvature(mesh, axes)).lines(contours(), make_view("v", v, {0, 0, 1}));
  ASSERT_EQ(lines.size(), 1u);
  const Vec3 across = normalized(Vec3{v.x / (axes.x * axes.x), v.y / (axes.y * axes.y), v.z / (axes.z * axes.z)});
  EXPECT_LT(farthest(lines, [&](const Vec3& p) { return dot(p, across); }), 0.15 * average_edge_length(mesh));
}

TEST(LineDrawing, SuggestiveContoursOfATorusObeyTheirEquation)
{
  const double major = 3, minor = 1, slant = 70 * pi / 180, sine = std::sin(slant), cosine = std::cos(slant);
  const TriangleMesh mesh = torus(major, minor, 280, 80);
  LineDrawingParameters p = none();
  p.suggestive_contours = true;
  const auto lines =
      Subject(mesh, torus_curvature(mesh, major, minor)).lines(p, make_view("v", {sine, 0, cosine}, {0, 0, 1}));
  ASSERT_FALSE(lines.empty());
  // κ_r sin²θ (R + r cosφ), divided by its own gradient: the distance from the line.
  const auto equation = [&](double phi, double psi) {
    const double rho = major + minor * std::cos(phi);
    return std::pow(cosine * std::cos(phi) - sine * std::sin(phi) * std::cos(psi), 2) * rho +
           minor * std::cos(phi) * std::pow(sine * std::sin(psi), 2);
  };
  const auto distance = [&](const Vec3& q) {
    const double rho = std::hypot(q.x, q.y), phi = std::atan2(q.z, rho - major), psi = std::atan2(q.y, q.x);
    constexpr double h = 1e-4;
    const double by_phi = (equation(phi + h, psi) - equation(phi - h, psi)) / (2 * h * minor);
    const double by_psi = (equation(phi, psi + h) - equation(phi, psi - h)) / (2 * h * rho);
    return equation(phi, psi) / std::hypot(by_phi, by_psi);
  };
  EXPECT_LT(farthest(lines, distance), 0.3 * average_edge_length(mesh));
}

TEST(LineDrawing, ATorusFromAboveHasNoSuggestiveContours)
{
  const TriangleMesh mesh = torus(3, 1, 280, 80);
  LineDrawingParameters p = none();
  p.suggestive_contours = true;
  EXPECT_TRUE(Subject(mesh, torus_curvature(mesh, 3, 1)).lines(p, from_above).empty());
}

// n·v = 1/√(1 + |∇z|²) is least where a slope is steepest: contours. Between two slopes it is largest: highlights.
TEST(LineDrawing, ASaddleFromAboveHasHighlightsOnItsDiagonalsAndNoSuggestiveContours)
{
  const HeightField f =
      height_field([](double x, double y) { return HeightJet{(x * x - y * y) / 2, x, -y, 1, 0, -1}; });
  Subject subject(f.mesh, f.result);
  LineDrawingParameters p = none();
  p.suggestive_contours = true;
  EXPECT_TRUE(subject.lines(p, from_above).empty());
  p.suggestive_contours = false;
  p.suggestive_highlights = true;
  const auto lines = subject.lines(p, from_above);
  EXPECT_GT(length_of(lines), 4 * 1.2) << "two diagonals of the length 2√2 each, and longer on the slope";
  EXPECT_LT(farthest(lines, [](const Vec3& q) { return std::abs(q.x) - std::abs(q.y); }), f.result.average_edge);
}

TEST(LineDrawing, ABumpFromAboveHasASuggestiveContourWhereItIsSteepest)
{
  const double s = 0.35;
  const HeightField f = height_field([&](double x, double y) {
    const double a = 0.3 * std::exp(-(x * x + y * y) / (2 * s * s)), s2 = s * s;
    return HeightJet{
        a, -a * x / s2, -a * y / s2, a * (x * x / s2 - 1) / s2, a * x * y / (s2 * s2), a * (y * y / s2 - 1) / s2};
  });
  LineDrawingParameters p = none();
  p.suggestive_contours = true;
  const auto lines = Subject(f.mesh, f.result).lines(p, from_above);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].line.closed);
  EXPECT_LT(farthest(lines, [&](const Vec3& q) { return std::hypot(q.x, q.y) - s; }), 0.1 * f.result.average_edge);
  EXPECT_NEAR(lines[0].line.length(), 2 * pi * s, 0.01 * 2 * pi * s);
}

TEST(LineDrawing, ASineHasDemarcatingCurvesAtItsInflectionsAndAnApparentRidgeOnItsCrests)
{
  const double a = 0.05, k = 2 * pi;
  const HeightField f = height_field([&](double x, double) {
    return HeightJet{a * std::sin(k * x), a * k * std::cos(k * x), 0, -a * k * k * std::sin(k * x), 0, 0};
  });
  Subject subject(f.mesh, f.result);
  LineDrawingParameters p = none();
  p.demarcating_curves = true;
  const auto inflections = subject.lines(p, from_above);
  EXPECT_NEAR(length_of(inflections), 3 * 2.0, 0.15 * 6) << "x = −1/2, 0, 1/2; those at ±1 are on the boundary";
  EXPECT_LT(farthest(inflections, [](const Vec3& q) { return q.x - std::round(2 * q.x) / 2; }),
            0.2 * f.result.average_edge);
  p = none();
  p.apparent_ridges = true;
  const auto crests = subject.lines(p, from_above);
  EXPECT_NEAR(length_of(crests), 4 * 2.0, 0.15 * 8) << "x = ±1/4, ±3/4";
  EXPECT_LT(farthest(crests, [](const Vec3& q) { return q.x - (std::round(2 * q.x - 0.5) + 0.5) / 2; }),
            0.2 * f.result.average_edge);
}

TEST(LineDrawing, TheFarSphereIsHiddenWhereTheDiscOfTheNearOneCoversIt)
{
  // Seen along z: unit discs 1.2 apart. The far outline is covered over the arc within acos(1.2/2) of the line between.
  const TriangleMesh near = icosphere(5), far = translated(near, {1.2, 0, -3});
  const TriangleMesh mesh = joined(near, far);
  Result result = sphere_curvature(near);
  const Result once = result;
  result.kappa_max.insert(result.kappa_max.end(), once.kappa_max.begin(), once.kappa_max.end());
  result.kappa_min.insert(result.kappa_min.end(), once.kappa_min.begin(), once.kappa_min.end());
  result.dir_max.insert(result.dir_max.end(), once.dir_max.begin(), once.dir_max.end());
  result.dir_min.insert(result.dir_min.end(), once.dir_min.begin(), once.dir_min.end());
  result.normal.insert(result.normal.end(), once.normal.begin(), once.normal.end());
  const auto lines = Subject(mesh, result).lines(contours(), from_above);
  EXPECT_EQ(lines.size(), 3u) << "one whole circle, one arc that is seen and one that is hidden";
  const double hidden = 2 * std::acos(0.6);
  EXPECT_NEAR(visible_length_of(lines), 4 * pi - hidden, 2 * average_edge_length(mesh));
  EXPECT_NEAR(length_of(lines), 4 * pi, 0.01 * 4 * pi);
}

TEST(LineDrawing, ContoursOfAnObliqueTorusEndAtCuspsInside)
{
  // The outer outline is seen whole. The inner one, an ellipse's parallel at the tube's radius, has cusps where the
  // ellipse bends more: 3 cos²α < 1. Near edge and far edge are seen, what lies between cusps and crossings is not.
  const double slant = 60 * pi / 180;
  const TriangleMesh mesh = torus(3, 1, 280, 80);
  const auto lines = Subject(mesh, torus_curvature(mesh, 3, 1))
                         .lines(contours(), make_view("v", {std::sin(slant), 0, std::cos(slant)}, {0, 0, 1}));
  std::size_t visible = 0, closed = 0;
  for (const ViewLine& l : lines) {
    visible += l.visible;
    closed += l.line.closed;
  }
  EXPECT_EQ(closed, 1u);
  EXPECT_EQ(visible, 3u) << "the outline, and the inner edge in front and behind";
}

TEST(LineDrawing, IsTheSameToTheBitOnAnyNumberOfThreads)
{
  const TriangleMesh mesh = torus(3, 1, 140, 40);
  LineDrawingParameters p;
  p.suggestive_highlights = p.apparent_ridges = p.ridges = p.valleys = p.demarcating_curves = p.hatching = true;
  p.sections = 3;
  const View view = make_view("v", {1, 0.3, 0.7}, {0, 0, 1});
  const auto one = Subject(mesh, torus_curvature(mesh, 3, 1), 1).lines(p, view);
  const auto three = Subject(mesh, torus_curvature(mesh, 3, 1), 3).lines(p, view);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].line.points.size(), three[i].line.points.size());
    for (std::size_t k = 0; k < one[i].line.points.size(); ++k)
      EXPECT_EQ(one[i].line.points[k].position, three[i].line.points[k].position);
  }
}

TEST(LineDrawing, RefusesWhatItCannotDraw)
{
  const TriangleMesh mesh = icosphere(2);
  Subject subject(mesh, sphere_curvature(mesh));
  EXPECT_THROW(subject.lines(none(), from_above), ParameterError);
  for (double LineDrawingParameters::*value :
       {&LineDrawingParameters::significance, &LineDrawingParameters::minimum_length,
        &LineDrawingParameters::crease_angle, &LineDrawingParameters::hatching_spacing}) {
    LineDrawingParameters p;
    p.*value = -1;
    EXPECT_THROW(subject.lines(p, from_above), ParameterError);
  }
  EXPECT_THROW(make_view("v", {0, 0, 0}, {0, 1, 0}), ParameterError);
  EXPECT_THROW(make_view("v", {0, 1, 0}, {0, 2, 0}), ParameterError);
}
