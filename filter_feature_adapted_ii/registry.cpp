// SPDX-License-Identifier: GPL-3.0-or-later
// The filters of the plugin, by number and by name.
#include "registry.h"

namespace integral_invariant::filter {

const std::vector<const Filter*>& all_filters()
{
  static const std::vector<const Filter*> filters = {
#define II_FILTER(name) &name##_filter(),
#include "registry.def"
#undef II_FILTER
  };
  return filters;
}

const Filter& find_filter(const std::string& name)
{
  std::string names;
  for (const Filter* filter : all_filters()) {
    if (name == filter->name || name == filter->python_name) return *filter;
    names += (names.empty() ? "" : ", ") + std::string(filter->python_name);
  }
  throw ParameterError("There is no filter '" + name + "'; the filters are " + names + ".");
}

FilterResult run_filter(const Filter& filter, const FilterInput& input, const ProgressCallback& progress)
{
  // These are the host layer's own; the core holds callers to the ranges of its parameters.
  for (const char* name : {"lift", "color_percentile"})
    if (const ParameterSpec* spec = find_parameter(filter.parameters, name)) require_permitted(*spec, input.request);
  return filter.run(input, progress);
}

}  // namespace integral_invariant::filter
