// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: the filters of the plugin.
#pragma once

#include <string>
#include <vector>

#include "filter.h"

namespace integral_invariant::filter {

inline constexpr const char* plugin_name = "FilterFeatureAdaptedII";

// One function a line of registry.def, each defined in the file of its filter.
#define II_FILTER(name) const Filter& name##_filter();
#include "registry.def"
#undef II_FILTER

/// All of them, in the order of registry.def. Hosts number them so.
const std::vector<const Filter*>& all_filters();

/// The filter with that name, in either spelling. \throw ParameterError that lists the names
const Filter& find_filter(const std::string& name);

/// Runs the filter: checks what the core does not, then Filter::run. \throw InputError and its kinds; Cancelled
FilterResult run_filter(const Filter& filter, const FilterInput& input, const ProgressCallback& progress = {});

}  // namespace integral_invariant::filter
