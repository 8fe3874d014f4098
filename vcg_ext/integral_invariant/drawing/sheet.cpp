// SPDX-License-Identifier: GPL-3.0-or-later
// Layout of views on paper. Cost: O(points · log).
#include "integral_invariant/drawing/sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "integral_invariant/drawing/paper_text.h"
#include "integral_invariant/drawing/simplification.h"
#include "integral_invariant/error.h"

namespace integral_invariant {

namespace {

constexpr double margin = 10, gap = 10;               // mm: of the sheet, between views
constexpr double label_height = 2.5, label_room = 7;  // mm: of a capital, and of the strip under a view
constexpr double foot = 12;                           // mm: for the scale bar
constexpr double tolerance = 0.02;                    // mm: a tenth of the thinnest line
constexpr double least_width_share = 0.6;             // of a line that is barely significant
constexpr double hidden_width_share = 0.6;
constexpr double largest_scale = 1e6;
constexpr double largest_sheet = 5000;  // mm: PDF readers take 200 inches

struct PaperSize {
  double width, height;
};
constexpr PaperSize a4{210, 297}, a3{297, 420};

void require(bool holds, const std::string& sentence)
{
  if (!holds) throw ParameterError(sentence);
}

double millimetres(LengthUnit unit)
{
  constexpr std::array<double, 4> lengths{1, 10, 1000, 25.4};
  return lengths[std::size_t(unit)];
}

/// A view's place in the unfolded box and its outline in the picture, in ē.
struct Cell {
  int column = 0, row = 0;
  Box box;

  double width() const { return box.high.x - box.low.x; }
  double height() const { return box.high.y - box.low.y; }
};

struct Place {
  int column, row;
};

/// Rows count downwards. Views without a name of a side follow in the row of the front.
Place place_of(const std::string& name, int& next_column)
{
  if (name == "left") return {0, 1};
  if (name == "front") return {1, 1};
  if (name == "right") return {2, 1};
  if (name == "back") return {3, 1};
  if (name == "top") return {1, 0};
  if (name == "bottom") return {1, 2};
  return {next_column++, 1};
}

class Layout {
 public:
  Layout(const std::vector<DrawnView>& views, const std::vector<Vec3>& positions)
  {
    int next_column = 4;
    for (const DrawnView& v : views) {
      const Place place = place_of(v.view.name, next_column);
      Cell cell{place.column, place.row, {}};
      for (const Vec3& p : positions) cell.box.add(v.view.project(p));
      cells_.push_back(cell);
      double &width = columns_[cell.column], &height = rows_[cell.row];
      width = std::max(width, cell.width());
      height = std::max(height, cell.height());
    }
  }

  /// mm, with `factor` millimetres an ē.
  PaperSize size(double factor) const
  {
    double width = 2 * margin + gap * double(columns_.size() - 1), height = 2 * margin + foot;
    for (const auto& [column, extent] : columns_) width += factor * extent;
    for (const auto& [row, extent] : rows_) height += factor * extent + label_room;
    return {width, height + gap * double(rows_.size() - 1)};
  }

  /// Lower left corner of a view's cell on a sheet of this size; the drawing stands in its middle.
  PaperPoint corner(std::size_t view, double factor, const PaperSize& sheet) const
  {
    const PaperSize used = size(factor);
    PaperPoint p{margin + (sheet.width - used.width) / 2, margin + foot + (sheet.height - used.height) / 2};
    for (const auto& [column, extent] : columns_)
      if (column < cells_[view].column) p.x += factor * extent + gap;
    for (const auto& [row, extent] : rows_) {
      if (row > cells_[view].row) p.y += factor * extent + gap + label_room;
    }
    p.y += label_room;
    // Narrower than its column, such as a view of its own: in the middle.
    p.x += factor * (columns_.at(cells_[view].column) - cells_[view].width()) / 2;
    p.y += factor * (rows_.at(cells_[view].row) - cells_[view].height()) / 2;
    return p;
  }

  const Cell& cell(std::size_t view) const { return cells_[view]; }

 private:
  std::vector<Cell> cells_;
  std::map<int, double> columns_, rows_;  ///< extents, ē
};

bool has_room(const PaperSize& paper, const PaperSize& used)
{
  return used.width <= paper.width && used.height <= paper.height;
}

/// Upright or turned: as the drawing is, where that has room.
PaperSize oriented(const PaperSize& paper, const PaperSize& used)
{
  const PaperSize turned{paper.height, paper.width};
  const bool is_wide = used.width > used.height;
  const PaperSize &first = is_wide ? turned : paper, &second = is_wide ? paper : turned;
  return !has_room(first, used) && has_room(second, used) ? second : first;
}

/// 1, 2 or 5 times a power of ten, at most `limit`.
double round_number_below(double limit)
{
  const double power = std::pow(10, std::floor(std::log10(limit)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= limit) return digit * power;
  return power;
}

/// n : 1 or 1 : n with a round n, at most `limit`.
double round_scale_below(double limit)
{
  if (limit >= 1) return round_number_below(limit);
  for (double power = 1;; power *= 10)
    for (const double digit : {2.0, 5.0, 10.0})
      if (1 / (digit * power) <= limit) return 1 / (digit * power);
}

double largest_factor(const Layout& layout, const PaperSize& paper)
{
  double best = 0;
  for (const PaperSize& p : {paper, PaperSize{paper.height, paper.width}}) {
    const PaperSize fixed = layout.size(0), one = layout.size(1);
    const double extent_x = one.width - fixed.width, extent_y = one.height - fixed.height;
    const double by_width = extent_x > 0 ? (p.width - fixed.width) / extent_x : HUGE_VAL;
    const double by_height = extent_y > 0 ? (p.height - fixed.height) / extent_y : HUGE_VAL;
    best = std::max(best, std::min(by_width, by_height));
  }
  return best;
}

std::string size_text(const PaperSize& size)
{
  return std::to_string(std::lround(size.width)) + " mm x " + std::to_string(std::lround(size.height)) + " mm";
}

double line_width(const ViewLine& line, double significance, const SheetParameters& p)
{
  const LineKind kind = line.line.kind;
  const bool is_outline = kind == LineKind::contour || kind == LineKind::boundary;
  const double width = is_outline ? p.outline_width : p.inner_width;
  if (!line.visible) return width * hidden_width_share;
  if (is_outline || !(significance > 0)) return width;
  double sum = 0;
  for (const LinePoint& point : line.line.points) sum += point.significance;
  const double excess = sum / double(line.line.points.size()) / significance - 1;
  return width * (least_width_share + (1 - least_width_share) * std::clamp(excess, 0.0, 1.0));
}

/// "5 mm", "2 cm", "1 m".
std::string length_text(double length)
{
  if (length < 10) return decimal_text(length) + " mm";
  return length < 1000 ? decimal_text(length / 10) + " cm" : decimal_text(length / 1000) + " m";
}

/// A bar of a round true length, about a quarter of the sheet, with ticks at its ends; the scale beside it.
void add_scale_bar(Sheet& sheet)
{
  constexpr double line = 0.25, tick = 1.5, share = 0.25;
  const double length = round_number_below(share * sheet.width / sheet.scale), on_paper = length * sheet.scale;
  const double x = margin, y = margin;
  sheet.scale_bar.push_back({{{x, y}, {x + on_paper, y}}, false, line});
  for (const double end : {x, x + on_paper})
    sheet.scale_bar.push_back({{{end, y - tick}, {end, y + tick}}, false, line});
  sheet.texts.push_back({{x + on_paper / 2, y + tick + 1}, label_height, length_text(length)});
  sheet.texts.push_back({{x + on_paper + 15, y - label_height / 2}, label_height, scale_text(sheet.scale)});
}

PaperLayer& layer_named(const std::string& name, bool dashed, std::vector<PaperLayer>& layers)
{
  for (PaperLayer& layer : layers)
    if (layer.name == name) return layer;
  layers.push_back({name, dashed, {}});
  return layers.back();
}

void add_lines(const DrawnView& drawn, const Cell& cell, const PaperPoint& corner, double factor, double significance,
               const SheetParameters& p, std::vector<PaperLayer>& layers)
{
  std::vector<PaperLayer> own;
  for (const ViewLine& line : drawn.lines) {
    PaperLine flat{{}, line.line.closed, line_width(line, significance, p)};
    for (const LinePoint& point : line.line.points) {
      const Vec3 q = drawn.view.project(point.position);
      flat.points.push_back({corner.x + factor * (q.x - cell.box.low.x), corner.y + factor * (q.y - cell.box.low.y)});
    }
    const std::string suffix = line.visible ? kind_name(line.line.kind) : "hidden";
    layer_named(drawn.view.name + "_" + suffix, !line.visible, own).lines.push_back(simplified(flat, tolerance));
  }
  layers.insert(layers.end(), own.begin(), own.end());
}

void check(const std::vector<DrawnView>& views, const SheetParameters& p)
{
  require(p.scale >= 0 && p.scale <= largest_scale, "The parameter 'sheet_scale' must be from 0 to 1000000.");
  require(p.outline_width > 0 && p.outline_width <= margin && p.inner_width > 0 && p.inner_width <= margin,
          "Line widths must be above 0 and at most 10 mm.");
  const bool is_empty = std::all_of(views.begin(), views.end(), [](const DrawnView& v) { return v.lines.empty(); });
  require(
      !is_empty,
      "The drawing is empty: no line was found in any view. Lower 'significance' or 'minimum_length', or ask for more "
      "kinds of lines.");
}

}  // namespace

std::string scale_text(double scale)
{
  return scale >= 1 ? decimal_text(scale) + " : 1" : "1 : " + decimal_text(1 / scale);
}

Sheet make_sheet(const std::vector<DrawnView>& views, const std::vector<Vec3>& positions, double unit,
                 double significance, const SheetParameters& p)
{
  check(views, p);
  const Layout layout(views, positions);
  const double true_length = unit * millimetres(p.unit);  // mm, of an ē
  const PaperSize paper = p.paper == Paper::a3 ? a3 : a4;
  Sheet sheet;
  sheet.scale = p.scale > 0 ? p.scale : round_scale_below(largest_factor(layout, paper) / true_length);
  const double factor = sheet.scale * true_length;
  const PaperSize used = layout.size(factor);
  const PaperSize size = p.paper == Paper::fitted ? used : oriented(paper, used);
  require(has_room(size, used),
          "At the scale " + scale_text(sheet.scale) + " the drawing is " + size_text(used) +
              ", more than the paper's " + size_text(size) +
              ". Choose a smaller 'sheet_scale' (0: automatic), larger paper or paper fitted to the drawing.");
  require(size.width <= largest_sheet && size.height <= largest_sheet,
          "At the scale " + scale_text(sheet.scale) + " the drawing is " + size_text(used) +
              ", more than 5 m. Choose a smaller 'sheet_scale' (0: automatic) or another 'mesh_unit'.");
  sheet.width = size.width;
  sheet.height = size.height;
  for (std::size_t v = 0; v < views.size(); ++v) {
    const PaperPoint corner = layout.corner(v, factor, size);
    add_lines(views[v], layout.cell(v), corner, factor, significance, p, sheet.layers);
    sheet.texts.push_back({{corner.x + factor * layout.cell(v).width() / 2, corner.y - label_room + 1.5},
                           label_height,
                           views[v].view.name});
  }
  add_scale_bar(sheet);
  return sheet;
}

}  // namespace integral_invariant
