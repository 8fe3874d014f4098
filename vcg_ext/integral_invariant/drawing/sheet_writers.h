// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: sheets as files. Each function gives a whole file, the same bytes for the same sheet.
#pragma once

#include <string>

#include "integral_invariant/drawing/sheet.h"

namespace integral_invariant {

/// SVG 1.1 in millimetres; layers are groups that Inkscape shows as layers.
std::string svg_file(const Sheet& sheet);

/// PDF 1.5, one page; layers are optional content that readers can switch off.
std::string pdf_file(const Sheet& sheet);

/// DXF R12 in ASCII, in millimetres; layers are layers. Hidden lines have the line type DASHED.
std::string dxf_file(const Sheet& sheet);

}  // namespace integral_invariant
