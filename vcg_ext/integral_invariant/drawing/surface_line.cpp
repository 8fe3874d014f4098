// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the kinds of lines.
#include "integral_invariant/drawing/surface_line.h"

#include <array>

namespace integral_invariant {

namespace {

struct Names {
  const char *title, *name;
};

const std::array<Names, line_kind_count> names{{{"contours", "contours"},
                                                {"boundaries", "boundaries"},
                                                {"creases", "creases"},
                                                {"suggestive contours", "suggestive_contours"},
                                                {"suggestive highlights", "suggestive_highlights"},
                                                {"apparent ridges", "apparent_ridges"},
                                                {"ridges", "ridges"},
                                                {"valleys", "valleys"},
                                                {"demarcating curves", "demarcating_curves"},
                                                {"hatching", "hatching"},
                                                {"sections", "sections"}}};

}  // namespace

const char* kind_title(LineKind kind) { return names[std::size_t(kind)].title; }
const char* kind_name(LineKind kind) { return names[std::size_t(kind)].name; }

}  // namespace integral_invariant
