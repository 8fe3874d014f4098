// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: filter scripts (.mlx) and the documentation of the parameters, from the table.
#pragma once

#include <string>

#include "parameter_table.h"

namespace integral_invariant::filter {

/// Reads "name=value" into `request`. \throw ParameterError for a name that is not in the table, or a bad value
void store_assignment(const std::string& assignment, Request& request, FilterId filter = FilterId::curvature);

/// An .mlx that applies the filter with every parameter: MeshLab 2020.09 accepts no fewer. All releases read it.
/// \throw ParameterError for a value that MeshLab's single precision cannot hold
std::string filter_script(const Request& request, FilterId filter = FilterId::curvature);

/// The parameters as a Markdown table.
std::string parameter_documentation(FilterId filter = FilterId::curvature);

/// One "name=default" a line.
std::string parameter_defaults(FilterId filter = FilterId::curvature);

}  // namespace integral_invariant::filter
