// SPDX-License-Identifier: GPL-3.0-or-later
// Names and help of the filters.
#include "filters.h"

#include "help_text.h"

namespace integral_invariant::filter {

const FilterFacts& filter_facts(FilterId filter)
{
  static const FilterFacts facts[filter_count] = {
      {filter_name, python_name, help_text},
      {"Select Ridges and Valleys by Curvature", "select_ridges_and_valleys_by_curvature", ridge_valley_help},
      {"Create Crest Lines Layer", "create_crest_lines_layer", crest_line_help},
      {"Create Principal Direction Layer", "create_principal_direction_layer", direction_help},
      {"Compute Multi-Scale Integral Invariant Signature", "compute_multi_scale_integral_invariant_signature",
       signature_help},
  };
  return facts[static_cast<int>(filter)];
}

FilterId find_filter(const std::string& name)
{
  std::string names;
  for (int i = 0; i < filter_count; ++i) {
    const auto filter = static_cast<FilterId>(i);
    const FilterFacts& facts = filter_facts(filter);
    if (name == facts.name || name == facts.python_name) return filter;
    names += (i ? ", " : "") + std::string(facts.python_name);
  }
  throw ParameterError("There is no filter '" + name + "'; the filters are " + names + ".");
}

}  // namespace integral_invariant::filter
