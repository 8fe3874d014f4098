// SPDX-License-Identifier: GPL-3.0-or-later
// Views on paper: true lengths, places of the views, layers; and the three kinds of files, read by other programs where
// they are installed.
#include "integral_invariant/drawing/sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "integral_invariant/drawing/paper_text.h"
#include "integral_invariant/drawing/sheet_writers.h"
#include "integral_invariant/drawing/simplification.h"
#include "integral_invariant/error.h"

using namespace integral_invariant;

namespace {

constexpr double pi = 3.14159265358979;

/// A box of 40 × 20 × 10 with a circle of the radius 5 on each of its sides, as the lines of six views. ē is 1.
struct BoxOfCircles {
  std::vector<Vec3> corners;
  std::vector<DrawnView> views;

  BoxOfCircles()
  {
    for (int i = 0; i < 8; ++i) corners.push_back({i & 1 ? 40.0 : 0, i & 2 ? 20.0 : 0, i & 4 ? 10.0 : 0});
    for (int side = 0; side < side_count; ++side) {
      const View view = side_view(Side(side));
      views.push_back({view, {circle(view, true), circle(view, false)}});
    }
  }

  static ViewLine circle(const View& view, bool visible)
  {
    constexpr int points = 720;
    ViewLine line{{LineKind::contour, {}, true}, visible};
    for (int i = 0; i < points; ++i) {
      const double angle = 2 * pi * i / points;
      const Vec3 p = Vec3{20, 10, 5} + view.right * (5 * std::cos(angle)) + view.up * (5 * std::sin(angle));
      line.line.points.push_back({p, view.toward, 10, 1});
    }
    return line;
  }

  Sheet sheet(const SheetParameters& p = {}) const { return make_sheet(views, corners, 1, 3, p); }
};

struct Extent {
  double left = 1e9, bottom = 1e9, right = -1e9, top = -1e9;
  double middle_x() const { return (left + right) / 2; }
  double middle_y() const { return (bottom + top) / 2; }
};

Extent extent_of(const PaperLayer& layer)
{
  Extent e;
  for (const PaperLine& line : layer.lines)
    for (const PaperPoint& p : line.points) {
      e.left = std::min(e.left, p.x);
      e.right = std::max(e.right, p.x);
      e.bottom = std::min(e.bottom, p.y);
      e.top = std::max(e.top, p.y);
    }
  return e;
}

const PaperLayer& layer(const Sheet& sheet, const std::string& name)
{
  for (const PaperLayer& l : sheet.layers)
    if (l.name == name) return l;
  throw std::runtime_error("no layer " + name);
}

SheetParameters with_scale(double scale)
{
  SheetParameters p;
  p.scale = scale;
  return p;
}

std::string sentence_of(const BoxOfCircles& box, const SheetParameters& p)
{
  try {
    box.sheet(p);
  } catch (const ParameterError& e) {
    return e.what();
  }
  return "";
}

/// A folder of its own that goes with it.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("sheet_test_" + std::to_string(std::rand())))
  {
    std::filesystem::create_directory(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }

  std::string write(const std::string& name, const std::string& bytes) const
  {
    const std::string file = (path_ / name).string();
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

bool has_program(const std::string& name) { return std::system(("command -v " + name + " > /dev/null").c_str()) == 0; }
bool runs(const std::string& command) { return std::system((command + " > /dev/null").c_str()) == 0; }

/// Whether the picture, 10 pixels a millimetre, has its leftmost and rightmost dark pixel of the row through the middle
/// of the front's circle where they belong, within 0.1 mm. A raw grey picture: P5, width, height, 255.
void expect_circle_in_picture(const std::string& pgm, const Sheet& sheet)
{
  std::ifstream in(pgm, std::ios::binary);
  std::string magic;
  int width = 0, height = 0, most = 0;
  in >> magic >> width >> height >> most;
  in.get();
  ASSERT_EQ(magic, "P5");
  EXPECT_NEAR(width, sheet.width * 10, 2);
  EXPECT_NEAR(height, sheet.height * 10, 2);
  std::string pixels(std::size_t(width) * std::size_t(height), ' ');
  in.read(pixels.data(), std::streamsize(pixels.size()));
  const Extent circle = extent_of(layer(sheet, "front_contours"));
  const int row = int((sheet.height - circle.middle_y()) * 10);
  const double half = 0.35 / 2;
  int first = -1, last = -1;
  for (int x = int(circle.left * 10) - 30; x < int(circle.right * 10) + 30; ++x) {
    if (static_cast<unsigned char>(pixels[std::size_t(row) * std::size_t(width) + std::size_t(x)]) > 127) continue;
    if (first < 0) first = x;
    last = x;
  }
  EXPECT_NEAR(first / 10.0, circle.left - half, 0.1);
  EXPECT_NEAR((last + 1) / 10.0, circle.right + half, 0.1);
}

}  // namespace

TEST(Sheet, LengthsAreTrue)
{
  const BoxOfCircles box;
  for (const double scale : {1.0, 0.5, 2.0}) {
    const Extent e = extent_of(layer(box.sheet(with_scale(scale)), "front_contours"));
    EXPECT_NEAR(e.right - e.left, 10 * scale, 0.02);
    EXPECT_NEAR(e.top - e.bottom, 10 * scale, 0.02);
  }
  SheetParameters inches = with_scale(1);
  inches.unit = LengthUnit::inch;
  const Extent e = extent_of(layer(box.sheet(inches), "top_contours"));
  EXPECT_NEAR(e.right - e.left, 254, 0.02);
}

TEST(Sheet, NeighbouringViewsStandOnOneLine)
{
  const Sheet sheet = BoxOfCircles().sheet(with_scale(1));
  const Extent front = extent_of(layer(sheet, "front_contours"));
  for (const char* side : {"left", "right", "back"})
    EXPECT_NEAR(extent_of(layer(sheet, side + std::string("_contours"))).middle_y(), front.middle_y(), 1e-6) << side;
  for (const char* side : {"top", "bottom"})
    EXPECT_NEAR(extent_of(layer(sheet, side + std::string("_contours"))).middle_x(), front.middle_x(), 1e-6) << side;
  EXPECT_LT(extent_of(layer(sheet, "left_contours")).right, front.left);
  EXPECT_GT(extent_of(layer(sheet, "right_contours")).left, front.right);
  EXPECT_GT(extent_of(layer(sheet, "top_contours")).bottom, front.top);
  EXPECT_LT(extent_of(layer(sheet, "bottom_contours")).top, front.bottom);
  for (const PaperLayer& l : sheet.layers) {
    const Extent e = extent_of(l);
    EXPECT_GT(e.left, 0);
    EXPECT_GT(e.bottom, 0);
    EXPECT_LT(e.right, sheet.width);
    EXPECT_LT(e.top, sheet.height);
  }
}

TEST(Sheet, ScaleAndBarAreRoundAndFit)
{
  const BoxOfCircles box;  // as an unfolded box 100 × 40 without gaps
  const Sheet sheet = box.sheet();
  EXPECT_EQ(sheet.scale, 2) << "297 mm has room for 200, not for 500";
  EXPECT_EQ(scale_text(sheet.scale), "2 : 1");
  EXPECT_EQ(scale_text(0.05), "1 : 20");
  ASSERT_EQ(sheet.scale_bar.size(), 3u);
  const double bar = sheet.scale_bar[0].points[1].x - sheet.scale_bar[0].points[0].x;
  EXPECT_NEAR(bar, 2 * 20, 1e-9);
  EXPECT_EQ(sheet.texts[sheet.texts.size() - 2].text, "2 cm");
  SheetParameters metres;
  metres.unit = LengthUnit::metre;
  EXPECT_EQ(scale_text(box.sheet(metres).scale), "1 : 500");
  SheetParameters a3;
  a3.paper = Paper::a3;
  EXPECT_NEAR(box.sheet(a3).width, 420, 1e-9) << "turned, as the drawing is wide";
}

TEST(Sheet, HiddenLinesHaveALayerOfTheirOwnAndThinnerDashes)
{
  const Sheet sheet = BoxOfCircles().sheet();
  const PaperLayer& hidden = layer(sheet, "back_hidden");
  EXPECT_TRUE(hidden.dashed);
  EXPECT_LT(hidden.lines[0].width, layer(sheet, "back_contours").lines[0].width);
  EXPECT_FALSE(layer(sheet, "back_contours").dashed);
}

TEST(Sheet, RefusesWithASentence)
{
  BoxOfCircles box;
  SheetParameters p = with_scale(10);
  p.paper = Paper::a4;
  EXPECT_NE(sentence_of(box, p).find("At the scale 10 : 1 the drawing is"), std::string::npos);
  EXPECT_NE(sentence_of(box, with_scale(-1)).find("'sheet_scale'"), std::string::npos);
  EXPECT_NE(sentence_of(box, with_scale(1e4)).find("more than 5 m"), std::string::npos);
  p = {};
  p.inner_width = 0;
  EXPECT_NE(sentence_of(box, p).find("Line widths"), std::string::npos);
  for (DrawnView& v : box.views) v.lines.clear();
  EXPECT_NE(sentence_of(box, {}).find("The drawing is empty"), std::string::npos);
}

TEST(Sheet, SimplifiedLinesStayWithinTheTolerance)
{
  PaperLine circle{{}, true, 1};
  for (int i = 0; i < 1000; ++i) circle.points.push_back({50 * std::cos(pi * i / 500), 50 * std::sin(pi * i / 500)});
  const PaperLine simple = simplified(circle, 0.02);
  EXPECT_LT(simple.points.size(), 2 * 111u) << "111 chords of a circle of 50 mm are all 0.02 mm from it";
  double length = 0;
  for (std::size_t i = 0; i < simple.points.size(); ++i) {
    const PaperPoint &a = simple.points[i], &b = simple.points[(i + 1) % simple.points.size()];
    length += std::hypot(b.x - a.x, b.y - a.y);
    EXPECT_GT(std::hypot((a.x + b.x) / 2, (a.y + b.y) / 2), 50 - 0.0201);
  }
  EXPECT_NEAR(length, 2 * pi * 50, 0.1);
  const PaperLine straight = simplified({{{0, 0}, {1, 0}, {2, 0}, {3, 0}}, false, 1}, 0.02);
  EXPECT_EQ(straight.points.size(), 2u);
}

TEST(Sheet, NumbersHaveAPointAndThreeDecimals)
{
  EXPECT_EQ(decimal_text(0.35), "0.35");
  EXPECT_EQ(decimal_text(-12), "-12");
  EXPECT_EQ(decimal_text(7.0006), "7.001");
  EXPECT_EQ(decimal_text(-0.05), "-0.05");
  EXPECT_EQ(decimal_text(1e-9), "0");
  EXPECT_EQ(decimal_text(-1e-9), "0");
}

TEST(SheetFiles, RsvgReadsTheSvgAtItsTrueSize)
{
  if (!has_program("rsvg-convert") || !has_program("pdftoppm")) GTEST_SKIP() << "rsvg-convert or pdftoppm is missing";
  const Sheet sheet = BoxOfCircles().sheet();
  const Folder folder;
  const std::string svg = folder.write("s.svg", svg_file(sheet));
  ASSERT_TRUE(runs("rsvg-convert -f pdf -o " + folder.file("s.pdf") + " " + svg));
  ASSERT_TRUE(runs("pdftoppm -gray -r 254 -singlefile " + folder.file("s.pdf") + " " + folder.file("s")));
  expect_circle_in_picture(folder.file("s.pgm"), sheet);
}

TEST(SheetFiles, PopplerReadsThePdfAtItsTrueSize)
{
  if (!has_program("pdftoppm")) GTEST_SKIP() << "pdftoppm is missing";
  const Sheet sheet = BoxOfCircles().sheet();
  const Folder folder;
  const std::string pdf = folder.write("s.pdf", pdf_file(sheet));
  ASSERT_TRUE(runs("pdftoppm -gray -r 254 -singlefile " + pdf + " " + folder.file("s")));
  expect_circle_in_picture(folder.file("s.pgm"), sheet);
}

TEST(SheetFiles, EzdxfReadsTheDxfWithItsLayersAndLengths)
{
  if (!runs("python3 -c 'import ezdxf' 2> /dev/null")) GTEST_SKIP() << "the Python package ezdxf is missing";
  const Folder folder;
  const std::string dxf = folder.write("s.dxf", dxf_file(BoxOfCircles().sheet(with_scale(1))));
  const std::string script = folder.write("read.py", R"(
import sys, ezdxf
document = ezdxf.readfile(sys.argv[1])
assert not document.audit().has_errors, document.audit().errors
assert {"front_contours", "back_hidden", "scale_bar", "labels"} <= {layer.dxf.name for layer in document.layers}
lines = [e for e in document.modelspace().query("POLYLINE") if e.dxf.layer == "front_contours"]
assert len(lines) == 1 and lines[0].is_closed
x = [v.dxf.location.x for v in lines[0].vertices]
assert abs(max(x) - min(x) - 10) < 0.1, max(x) - min(x)
assert document.layers.get("back_hidden").dxf.linetype == "DASHED"
)");
  EXPECT_TRUE(runs("python3 " + script + " " + dxf));
}

TEST(SheetFiles, AreTheSameBytesForTheSameSheet)
{
  const BoxOfCircles box;
  EXPECT_EQ(svg_file(box.sheet()), svg_file(box.sheet()));
  EXPECT_EQ(pdf_file(box.sheet()), pdf_file(box.sheet()));
  EXPECT_EQ(dxf_file(box.sheet()), dxf_file(box.sheet()));
}
