// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_result.h"

namespace integral_invariant::filter {

unsigned written_fields(const FilterResult& result)
{
  unsigned fields = 0;
  if (result.curvature) fields |= field_curvature | field_radius;
  if (!result.selection.empty()) fields |= field_selection;
  if (!result.quality.empty()) fields |= field_quality;
  if (!result.colors.empty()) fields |= field_color;
  return fields;
}

}  // namespace integral_invariant::filter
