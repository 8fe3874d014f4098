// SPDX-License-Identifier: GPL-3.0-or-later
// SVG: the y axis points down there.
#include "integral_invariant/drawing/paper_text.h"
#include "integral_invariant/drawing/sheet_writers.h"

namespace integral_invariant {

namespace {

constexpr double capital_over_size = 0.72;  // of the usual sans-serif fonts

class SvgWriter {
 public:
  explicit SvgWriter(const Sheet& sheet) : sheet_(sheet) {}

  std::string file()
  {
    const std::string width = decimal_text(sheet_.width), height = decimal_text(sheet_.height);
    text_ = R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" version="1.1" width=")" +
            width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + " " + height + "\">\n";
    for (const PaperLayer& layer : sheet_.layers) add_group(layer);
    add_group({"scale_bar", false, sheet_.scale_bar});
    add_texts();
    return text_ + "</svg>\n";
  }

 private:
  void add_group(const PaperLayer& layer)
  {
    text_ += "<g inkscape:groupmode=\"layer\" id=\"" + layer.name + "\" inkscape:label=\"" + layer.name +
             "\" fill=\"none\" stroke=\"black\" stroke-linecap=\"round\" stroke-linejoin=\"round\"";
    if (layer.dashed) text_ += " stroke-dasharray=\"1.2 0.8\"";
    text_ += ">\n";
    for (const PaperLine& line : layer.lines) add_path(line);
    text_ += "</g>\n";
  }

  void add_path(const PaperLine& line)
  {
    text_ += "<path stroke-width=\"" + decimal_text(line.width) + "\" d=\"";
    for (std::size_t i = 0; i < line.points.size(); ++i)
      text_ += (i == 0 ? "M" : i == 1 ? "L" : " ") + decimal_text(line.points[i].x) + "," + y_text(line.points[i].y);
    text_ += line.closed ? "Z\"/>\n" : "\"/>\n";
  }

  void add_texts()
  {
    text_ +=
        "<g inkscape:groupmode=\"layer\" id=\"labels\" inkscape:label=\"labels\" font-family=\"sans-serif\" "
        "text-anchor=\"middle\">\n";
    for (const PaperText& t : sheet_.texts)
      text_ += "<text x=\"" + decimal_text(t.middle.x) + "\" y=\"" + y_text(t.middle.y) + "\" font-size=\"" +
               decimal_text(t.height / capital_over_size) + "\">" + t.text + "</text>\n";
    text_ += "</g>\n";
  }

  std::string y_text(double y) const { return decimal_text(sheet_.height - y); }

  const Sheet& sheet_;
  std::string text_;
};

}  // namespace

std::string svg_file(const Sheet& sheet) { return SvgWriter(sheet).file(); }

}  // namespace integral_invariant
