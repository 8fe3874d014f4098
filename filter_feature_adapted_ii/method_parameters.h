// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: the parameters of the method, and those of the output that filters share.
#pragma once

#include <initializer_list>
#include <vector>

#include "parameter_list.h"

namespace integral_invariant::filter {

/// What chooses radii, estimator and engine. Writes integral_invariant::Parameters.
std::vector<ParameterSpec> method_parameters();

/// The rest of the method: few people change it, and the later releases' dialogs show it on request only.
std::vector<ParameterSpec> detail_parameters();

/// Those of both lists that have these names, in the order of the names. \throw std::logic_error for one that is in
/// neither
std::vector<ParameterSpec> method_parameters(std::initializer_list<const char*> names);

/// How much of the values the colours cover. Writes OutputOptions.
ParameterSpec color_percentile_parameter();

}  // namespace integral_invariant::filter
