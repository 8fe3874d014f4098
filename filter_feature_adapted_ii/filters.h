// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: the filters of the plugin and their names.
#pragma once

#include <string>

#include "parameter_table.h"

namespace integral_invariant::filter {

struct FilterFacts {
  const char* name;         ///< in menus and filter scripts
  const char* python_name;  ///< in PyMeshLab
  const char* help;         ///< simple HTML
};
const FilterFacts& filter_facts(FilterId filter);

/// The filter with that name, in either spelling. \throw ParameterError that lists the names
FilterId find_filter(const std::string& name);

}  // namespace integral_invariant::filter
