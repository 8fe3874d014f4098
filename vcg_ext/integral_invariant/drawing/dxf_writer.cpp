// SPDX-License-Identifier: GPL-3.0-or-later
// DXF of AutoCAD Release 12: pairs of a group code and a value, a line each. It has no lengths of its own; the numbers
// are millimetres.
#include "integral_invariant/drawing/paper_text.h"
#include "integral_invariant/drawing/sheet_writers.h"

namespace integral_invariant {

namespace {

class DxfWriter {
 public:
  explicit DxfWriter(const Sheet& sheet) : sheet_(sheet) {}

  std::string file()
  {
    add_header();
    add_tables();
    pair(0, "SECTION");
    pair(2, "ENTITIES");
    for (const PaperLayer& layer : sheet_.layers)
      for (const PaperLine& line : layer.lines) add_polyline(line, layer.name);
    for (const PaperLine& line : sheet_.scale_bar) add_polyline(line, "scale_bar");
    for (const PaperText& text : sheet_.texts) add_text(text);
    pair(0, "ENDSEC");
    pair(0, "EOF");
    return text_;
  }

 private:
  void pair(int code, const std::string& value) { text_ += std::to_string(code) + "\n" + value + "\n"; }
  void pair(int code, double value) { pair(code, decimal_text(value)); }
  void point(const PaperPoint& p)
  {
    pair(10, p.x);
    pair(20, p.y);
    pair(30, 0.0);
  }

  void add_header()
  {
    pair(0, "SECTION");
    pair(2, "HEADER");
    pair(9, "$ACADVER");
    pair(1, "AC1009");
    pair(9, "$EXTMIN");
    point({0, 0});
    pair(9, "$EXTMAX");
    point({sheet_.width, sheet_.height});
    pair(0, "ENDSEC");
  }

  void begin_table(const char* name, std::size_t count)
  {
    pair(0, "TABLE");
    pair(2, name);
    pair(70, std::to_string(count));
  }

  void add_line_type(const char* name, const char* look, double dash, double space)
  {
    pair(0, "LTYPE");
    pair(2, name);
    pair(70, "0");
    pair(3, look);
    pair(72, "65");
    pair(73, dash > 0 ? "2" : "0");
    pair(40, dash + space);
    if (!(dash > 0)) return;
    pair(49, dash);
    pair(49, -space);
  }

  void add_layer(const std::string& name, bool dashed)
  {
    pair(0, "LAYER");
    pair(2, name);
    pair(70, "0");
    pair(62, "7");
    pair(6, dashed ? "DASHED" : "CONTINUOUS");
  }

  void add_tables()
  {
    pair(0, "SECTION");
    pair(2, "TABLES");
    begin_table("LTYPE", 2);
    add_line_type("CONTINUOUS", "Solid line", 0, 0);
    add_line_type("DASHED", "__ __ __", 1.2, 0.8);
    pair(0, "ENDTAB");
    begin_table("LAYER", sheet_.layers.size() + 2);
    for (const PaperLayer& layer : sheet_.layers) add_layer(layer.name, layer.dashed);
    add_layer("scale_bar", false);
    add_layer("labels", false);
    pair(0, "ENDTAB");
    pair(0, "ENDSEC");
  }

  void add_polyline(const PaperLine& line, const std::string& layer)
  {
    pair(0, "POLYLINE");
    pair(8, layer);
    pair(66, "1");
    point({0, 0});
    pair(70, line.closed ? "1" : "0");
    pair(40, line.width);
    pair(41, line.width);
    for (const PaperPoint& p : line.points) {
      pair(0, "VERTEX");
      pair(8, layer);
      point(p);
    }
    pair(0, "SEQEND");
    pair(8, layer);
  }

  void add_text(const PaperText& t)
  {
    pair(0, "TEXT");
    pair(8, "labels");
    point(t.middle);
    pair(40, t.height);
    pair(1, t.text);
    pair(72, "1");  // the middle of the base line is the second point
    pair(11, t.middle.x);
    pair(21, t.middle.y);
    pair(31, 0.0);
  }

  const Sheet& sheet_;
  std::string text_;
};

}  // namespace

std::string dxf_file(const Sheet& sheet) { return DxfWriter(sheet).file(); }

}  // namespace integral_invariant
