// SPDX-License-Identifier: GPL-3.0-or-later
// PDF: objects, their places in the file, and a page whose content is drawn in millimetres. Source: ISO 32000-1.
#include <vector>

#include "integral_invariant/drawing/paper_text.h"
#include "integral_invariant/drawing/sheet_writers.h"

namespace integral_invariant {

namespace {

constexpr double points_in_millimetre = 72 / 25.4;
constexpr const char* millimetre_matrix = "2.834646 0 0 2.834646 0 0 cm\n";
constexpr double capital_over_size = 0.718, mean_advance = 0.5;  // of Helvetica, in font sizes

class PdfWriter {
 public:
  explicit PdfWriter(const Sheet& sheet) : sheet_(sheet) {}

  std::string file()
  {
    text_ = "%PDF-1.5\n%\xE2\xE3\xCF\xD3\n";
    const std::string groups = group_references();
    add_object("<< /Type /Catalog /Pages 2 0 R /OCProperties << /OCGs [" + groups + "] /D << /Order [" + groups +
               "] /ON [" + groups + "] >> >> >>");
    add_object("<< /Type /Pages /Kids [3 0 R] /Count 1 >>");
    add_object("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 " + decimal_text(sheet_.width * points_in_millimetre) +
               " " + decimal_text(sheet_.height * points_in_millimetre) +
               "] /Contents 5 0 R /Resources << /Font << /F1 4 0 R >> /Properties << " + properties() + ">> >> >>");
    add_object("<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>");
    const std::string page = content();
    add_object("<< /Length " + std::to_string(page.size()) + " >>\nstream\n" + page + "endstream");
    for (const PaperLayer& layer : sheet_.layers) add_object("<< /Type /OCG /Name (" + layer.name + ") >>");
    add_trailer();
    return text_;
  }

 private:
  static constexpr std::size_t first_group = 6;  // object number of the first layer

  void add_object(const std::string& body)
  {
    places_.push_back(text_.size());
    text_ += std::to_string(places_.size()) + " 0 obj\n" + body + "\nendobj\n";
  }

  std::string group_references() const
  {
    std::string list;
    for (std::size_t i = 0; i < sheet_.layers.size(); ++i) list += std::to_string(first_group + i) + " 0 R ";
    return list;
  }

  std::string properties() const
  {
    std::string list;
    for (std::size_t i = 0; i < sheet_.layers.size(); ++i)
      list += "/L" + std::to_string(i) + " " + std::to_string(first_group + i) + " 0 R ";
    return list;
  }

  std::string content() const
  {
    std::string page = std::string(millimetre_matrix) + "1 J 1 j\n";
    for (std::size_t i = 0; i < sheet_.layers.size(); ++i) {
      page += "/OC /L" + std::to_string(i) + " BDC\n";
      page += sheet_.layers[i].dashed ? "[1.2 0.8] 0 d\n" : "[] 0 d\n";
      for (const PaperLine& line : sheet_.layers[i].lines) add_path(line, page);
      page += "EMC\n";
    }
    page += "[] 0 d\n";
    for (const PaperLine& line : sheet_.scale_bar) add_path(line, page);
    for (const PaperText& t : sheet_.texts) add_text(t, page);
    return page;
  }

  static void add_path(const PaperLine& line, std::string& page)
  {
    page += decimal_text(line.width) + " w\n";
    for (std::size_t i = 0; i < line.points.size(); ++i)
      page += decimal_text(line.points[i].x) + " " + decimal_text(line.points[i].y) + (i == 0 ? " m\n" : " l\n");
    page += line.closed ? "s\n" : "S\n";
  }

  /// The words are short: their middle by the mean width of a letter is good to a millimetre.
  static void add_text(const PaperText& t, std::string& page)
  {
    const double size = t.height / capital_over_size;
    const double width = mean_advance * size * double(t.text.size());
    page += "BT /F1 " + decimal_text(size) + " Tf " + decimal_text(t.middle.x - width / 2) + " " +
            decimal_text(t.middle.y) + " Td (" + t.text + ") Tj ET\n";
  }

  void add_trailer()
  {
    const std::size_t start = text_.size(), count = places_.size() + 1;
    text_ += "xref\n0 " + std::to_string(count) + "\n0000000000 65535 f \n";
    constexpr std::size_t digits = 10;  // the table has fixed columns
    for (const std::size_t place : places_) {
      const std::string number = std::to_string(place);
      text_ += std::string(digits - number.size(), '0') + number + " 00000 n \n";
    }
    text_ += "trailer\n<< /Size " + std::to_string(count) + " /Root 1 0 R >>\nstartxref\n" + std::to_string(start) +
             "\n%%EOF\n";
  }

  const Sheet& sheet_;
  std::string text_;
  std::vector<std::size_t> places_;  ///< of the objects in the file
};

}  // namespace

std::string pdf_file(const Sheet& sheet) { return PdfWriter(sheet).file(); }

}  // namespace integral_invariant
