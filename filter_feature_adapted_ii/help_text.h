// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: the names of the filter and its help.
#pragma once

namespace integral_invariant::filter {

inline constexpr const char* plugin_name = "FilterFeatureAdaptedII";
inline constexpr const char* filter_name = "Compute Curvature by Integral Invariants per Vertex";
inline constexpr const char* python_name = "compute_curvature_by_integral_invariants_per_vertex";

/// The help of the filter in simple HTML: method, conventions, formula, references.
extern const char* const help_text;

/// Those of the other filters.
extern const char *const ridge_valley_help, *const crest_line_help, *const direction_help, *const signature_help;

}  // namespace integral_invariant::filter
