// SPDX-License-Identifier: GPL-3.0-or-later
// Line drawings against closed forms. Usage: line_accuracy [--without-classic] [shape ...]
//
// For each shape, view, kind of line and noise: precision, recall and length of the lines from this library's default
// field and default drawing, and from the classic estimator at the slider and threshold that are best for that cell.
// Prints a table in Markdown.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

#include "classic.h"
#include "exact_lines.h"
#include "integral_invariant/drawing/line_drawing.h"
#include "integral_invariant/drawing/line_scalars.h"
#include "integral_invariant/drawing/ridge_scalars.h"
#include "integral_invariant/curvature.h"
#include "integral_invariant/support/pi.h"
#include "score.h"

using namespace integral_invariant;
using namespace line_benchmark;

namespace {

struct Noise {
  double sigma, correlation;
  double tolerance() const { return sigma > 0.3 ? 2 : 1; }
};
constexpr Noise noises[] = {{0, 0}, {0.05, 0}, {0.1, 0}, {0.2, 0}, {0.5, 0}, {0.1, 3}};

/// What is drawn of a shape, and where it should be.
struct Drawing {
  LineKind kind;
  double slant = 0, turn = 0;  ///< degrees: from the z axis, around it
  std::vector<double> at_x;    ///< lines x = const, where they are these; otherwise exact_lines() finds them
};

struct Subject {
  Shape shape;
  std::vector<Drawing> drawings;
};

Vec3 toward(const Drawing& d)
{
  const double a = d.slant * pi / 180, b = d.turn * pi / 180;
  return {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
}

std::vector<Subject> subjects()
{
  const auto sc = LineKind::suggestive_contour;
  std::vector<Subject> all;
  all.push_back(
      {torus_shape(),
       {{LineKind::contour, 60, 10, {}}, {sc, 30, 10, {}}, {sc, 50, 10, {}}, {sc, 70, 10, {}}, {sc, 90, 10, {}}}});
  all.push_back({ellipsoid_shape(), {{LineKind::contour, 40, 25, {}}, {LineKind::contour, 80, 70, {}}}});
  all.push_back({height_field("saddle", [](double x, double y) { return (x * x - y * y) / 80; }), {{sc, 0, 0, {}}}});
  const auto bump = [](double x, double y) { return 8 * std::exp(-(x * x + y * y) / (2 * 12 * 12)); };
  all.push_back({height_field("bump", bump), {{sc, 0, 0, {}}, {sc, 40, 20, {}}}});
  all.push_back(
      {height_field("dimple", [=](double x, double y) { return -bump(x, y); }), {{sc, 0, 0, {}}, {sc, 40, 20, {}}}});
  const double k = 2 * pi / 30;
  all.push_back(
      {height_field("sine", [=](double x, double) { return 2 * std::sin(k * x); }),
       {{sc, 0, 0, {}}, {sc, 60, 0, {}}, {LineKind::demarcating_curve, 0, 0, {-45, -30, -15, 0, 15, 30, 45}}}});
  all.push_back({height_field("cosine", [=](double x, double) { return 2 * std::cos(k * x); }),
                 {{LineKind::apparent_ridge, 0, 0, {-45, -30, -15, 0, 15, 30, 45}},
                  {LineKind::ridge, 0, 0, {-30, 0, 30}},
                  {LineKind::valley, 0, 0, {-45, -15, 15, 45}}}});
  all.push_back({height_field("step", [](double x, double) { return 5 * std::tanh(x / 8); }),
                 {{LineKind::demarcating_curve, 0, 0, {0}}}});
  return all;
}

std::vector<ExactSegment> expected(const Shape& shape, const Drawing& drawing)
{
  if (drawing.at_x.empty()) return exact_lines(shape, drawing.kind, toward(drawing));
  std::vector<ExactSegment> lines;
  constexpr int pieces = 400;
  for (const double x : drawing.at_x)
    for (int i = 0; i < pieces; ++i) {
      const auto at = [&](int k) { return shape.t_begin + (shape.t_end - shape.t_begin) * k / pieces; };
      if (std::abs(x) < shape.s_end) lines.push_back({shape.position(x, at(i)), shape.position(x, at(i + 1))});
    }
  return lines;
}

/// Those within the margin of the shape; `scale` and `shift` lead from the surface's coordinates to the shape's.
std::vector<ExactSegment> segments_of(const std::vector<SurfaceLine>& lines, const Shape& shape, double scale,
                                      const Vec3& shift)
{
  std::vector<ExactSegment> segments;
  const auto is_judged = [&](const Vec3& p) {
    return shape.margin == 0 || (p.x > shape.s_begin && p.x < shape.s_end && p.y > shape.t_begin && p.y < shape.t_end);
  };
  for (const SurfaceLine& line : lines)
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
      const ExactSegment s{line.points[i].position * scale + shift, line.end_of(i).position * scale + shift};
      if (is_judged((s.a + s.b) * 0.5)) segments.push_back(s);
    }
  return segments;
}

LineDrawingParameters only(LineKind kind)
{
  LineDrawingParameters p;
  p.contours = kind == LineKind::contour;
  p.boundaries = p.creases = false;
  p.suggestive_contours = kind == LineKind::suggestive_contour;
  p.apparent_ridges = kind == LineKind::apparent_ridge;
  p.ridges = kind == LineKind::ridge;
  p.valleys = kind == LineKind::valley;
  p.demarcating_curves = kind == LineKind::demarcating_curve;
  p.hidden = HiddenLines::dashed;
  return p;
}

/// A noisy mesh, measured.
class Measured {
 public:
  Measured(const Shape& shape, const Noise& noise) : shape_(shape)
  {
    constexpr std::uint32_t seed = 20;
    mesh_ = with_noise(shape.mesh, noise.sigma, noise.correlation, seed);
    surface_.emplace(mesh_);
    topology_.emplace(*surface_, execution_);
    result_ = compute_curvature(mesh_, {});
    field_ = differentiate(*surface_, measured_field(result_), execution_);
  }

  std::vector<ExactSegment> drawn(const Drawing& drawing)
  {
    const LineDrawing lines(*surface_, *topology_, field_, result_.noise / result_.average_edge, only(drawing.kind),
                            execution_);
    const View view = make_view("view", toward(drawing), {0.1, 0.9, 0.2});
    std::vector<SurfaceLine> all;
    for (const ViewLine& line : lines.lines_of(view, execution_)) all.push_back(line.line);
    return in_shape(all);
  }

  Score classic(const Drawing& drawing, const std::vector<ExactSegment>& exact, double tolerance)
  {
    Score best;
    for (const double smoothing : {0.0, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0}) {
      if (!classic_.count(smoothing)) classic_[smoothing] = classic_field(*surface_, smoothing);
      for (const double threshold : {0.0, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3}) {
        const Score s = score(exact, in_shape(classic_lines(classic_[smoothing], drawing, threshold)), tolerance);
        if (s.f() > best.f()) best = s;
      }
    }
    return best;
  }

 private:
  std::vector<SurfaceLine> classic_lines(const DifferentiatedField& field, const Drawing& drawing, double threshold)
  {
    const View view = make_view("view", toward(drawing), {0.1, 0.9, 0.2});
    LineScalar scalar = drawing.kind == LineKind::contour
                            ? contour_scalar(field, view, execution_)
                            : suggestive_scalar(field, view, LineKind::suggestive_contour, execution_);
    for (std::size_t v = 0; v < field.size(); ++v) {
      const bool is_kept = drawing.kind == LineKind::contour || scalar.strength[v] > threshold;
      scalar.significance[v] = is_kept ? largest_significance : 0;
    }
    return zero_lines(*surface_, *topology_, field, scalar, {1, 0}, execution_);
  }

  std::vector<ExactSegment> in_shape(const std::vector<SurfaceLine>& lines) const
  {
    const double unit = surface_->unit();
    return segments_of(lines, shape_, unit, mesh_.positions[0] - surface_->positions()[0] * unit);
  }

  const Shape& shape_;
  Execution execution_;
  TriangleMesh mesh_;
  std::optional<Surface> surface_;
  std::optional<Topology> topology_;
  Result result_;
  DifferentiatedField field_;
  std::map<double, DifferentiatedField> classic_;
};

enum class Rival { none, classic };

bool has_classic(LineKind kind) { return kind == LineKind::contour || kind == LineKind::suggestive_contour; }

void report_sphere()
{
  const Shape shape = sphere_shape();
  for (const Noise& noise : noises) {
    Measured measured(shape, noise);
    double contour = 0;
    for (const ExactSegment& s : measured.drawn({LineKind::contour, 33, 10, {}})) contour += norm(s.b - s.a);
    for (const LineKind kind : {LineKind::suggestive_contour, LineKind::apparent_ridge, LineKind::ridge,
                                LineKind::valley, LineKind::demarcating_curve}) {
      double false_length = 0;
      for (const ExactSegment& s : measured.drawn({kind, 33, 10, {}})) false_length += norm(s.b - s.a);
      std::printf("| sphere | %s | | %g | %g | false length over contour's: %.3f |\n", kind_title(kind), noise.sigma,
                  noise.correlation, false_length / contour);
    }
  }
}

void report(const Subject& subject, const Noise& noise, Rival rival)
{
  Measured measured(subject.shape, noise);
  for (const Drawing& drawing : subject.drawings) {
    const auto exact = expected(subject.shape, drawing);
    const Score ours = score(exact, measured.drawn(drawing), noise.tolerance());
    std::printf("| %s | %s | %g, %g | %g | %g | %.3f | %.3f | %.2f |", subject.shape.name.c_str(),
                kind_title(drawing.kind), drawing.slant, drawing.turn, noise.sigma, noise.correlation, ours.precision,
                ours.recall, ours.length_ratio);
    if (rival == Rival::classic && has_classic(drawing.kind)) {
      const Score classic = measured.classic(drawing, exact, noise.tolerance());
      std::printf(" %.3f | %.3f | %.2f |", classic.precision, classic.recall, classic.length_ratio);
    } else {
      std::printf(" | | |");
    }
    const bool is_met = ours.precision >= 0.95 && ours.recall >= 0.95 && std::abs(ours.length_ratio - 1) < 0.1;
    std::printf(" %s |\n", is_met ? "met" : "missed");
    std::fflush(stdout);
  }
}

}  // namespace

int main(int count, char** arguments)
{
  std::vector<std::string> names(arguments + 1, arguments + count);
  const auto option = std::find(names.begin(), names.end(), "--without-classic");
  const Rival rival = option == names.end() ? Rival::classic : Rival::none;
  if (option != names.end()) names.erase(option);
  const auto is_wanted = [&](const std::string& name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
  };
  std::printf(
      "| shape | lines | view | σ/ē | correlation/ē | precision | recall | length | classic: precision | recall "
      "| length | goal |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Subject& subject : subjects())
    for (const Noise& noise : noises)
      if (is_wanted(subject.shape.name)) report(subject, noise, rival);
  if (is_wanted("sphere")) report_sphere();
}
