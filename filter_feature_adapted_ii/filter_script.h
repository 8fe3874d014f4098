// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: filter scripts (.mlx) and the documentation of the parameters, from its list of
// parameters.
#pragma once

#include <string>

#include "filter.h"

namespace integral_invariant::filter {

/// Reads "name=value" into `request`. \throw ParameterError for a name that the filter does not have, or a bad value
void store_assignment(const Filter& filter, const std::string& assignment, Request& request);

/// An .mlx that applies the filter with every parameter: MeshLab 2020.09 accepts no fewer. All releases read it.
/// \throw ParameterError for a value that MeshLab's single precision cannot hold
std::string filter_script(const Filter& filter, const Request& request);

/// The parameters as a Markdown table.
std::string parameter_documentation(const Filter& filter);

/// One "name=default" a line.
std::string parameter_defaults(const Filter& filter);

}  // namespace integral_invariant::filter
