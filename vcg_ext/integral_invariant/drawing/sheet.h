// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: views laid out on paper at true scale. In: lines of views, lengths in ē. Out: polylines in millimetres.
#pragma once

#include <string>
#include <vector>

#include "integral_invariant/drawing/line_drawing.h"

namespace integral_invariant {

/// Millimetres from the lower left corner of the sheet, y upwards.
struct PaperPoint {
  double x = 0, y = 0;
};

struct PaperLine {
  std::vector<PaperPoint> points;
  bool closed = false;
  double width = 0;  ///< mm
};

/// The lines of one kind in one view, or all that are hidden in it.
struct PaperLayer {
  std::string name;  ///< lower-case letters, digits and underscores, at most 31, such as "front_contours"
  bool dashed = false;
  std::vector<PaperLine> lines;
};

struct PaperText {
  PaperPoint middle;  ///< of its base line
  double height = 0;  ///< of a capital, mm
  std::string text;   ///< ASCII
};

struct Sheet {
  double width = 0, height = 0;  ///< mm
  double scale = 1;              ///< length on paper over true length
  std::vector<PaperLayer> layers;
  std::vector<PaperLine> scale_bar;
  std::vector<PaperText> texts;
};

enum class LengthUnit { millimetre = 0, centimetre = 1, metre = 2, inch = 3 };
enum class Paper { fitted = 0, a4 = 1, a3 = 2 };

struct SheetParameters {
  LengthUnit unit = LengthUnit::millimetre;  ///< of the mesh
  /// Length on paper over true length; 0: the largest of 1, 2, 5 times a power of ten, or one over it, that the paper
  /// has room for.
  double scale = 0;
  Paper paper = Paper::fitted;  ///< fitted: A4 for the choice of the scale, then cut to the drawing
  double outline_width = 0.35;  ///< mm; of contours and boundaries
  double inner_width = 0.18;    ///< mm; of all other lines
};

/// A view with its lines.
struct DrawnView {
  View view;
  std::vector<ViewLine> lines;
};

/// Lays the views out: the six sides as the faces of an unfolded box (left, front, right, back in a row, top and bottom
/// over and under the front, so that corresponding points of neighbours stand on one line), other views in the row
/// after them; each with its name under it, and a scale bar at the foot. `positions` are the vertices in ē, `unit` the
/// length of ē in the mesh's unit, `significance` the least z of a line: lines are thinner near it and have all of
/// their width from twice that on. Lines are simplified within 0.02 mm. \throw ParameterError where a parameter is out
/// of its range, nothing is visible, or the paper has no room
Sheet make_sheet(const std::vector<DrawnView>& views, const std::vector<Vec3>& positions, double unit,
                 double significance, const SheetParameters& parameters);

/// "1 : 2", "5 : 1"; with a decimal where it is none of these.
std::string scale_text(double scale);

}  // namespace integral_invariant
