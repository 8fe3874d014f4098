// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: what filters that work on curvatures begin and end with.
#pragma once

#include <string>
#include <vector>

#include "filter.h"
#include "integral_invariant/mesh/canonical_mesh.h"
#include "integral_invariant/mesh/surface.h"
#include "parameter_list.h"

namespace integral_invariant::filter {

inline constexpr int most_passes = 100;  ///< of smoothing curvatures over the mesh

/// What decides the curvatures, for filters whose dialog has parameters of its own to show.
std::vector<ParameterSpec> curvature_source_parameters();

/// The mesh with its curvatures, and the run that works on them; everything in canonical order.
struct MeasuredMesh {
  /// \throw InputError and its kinds, Cancelled
  MeasuredMesh(const FilterInput& input, const ProgressCallback& progress);

  CanonicalMesh canonical;
  Result curvature;
  Execution execution;  ///< has begun; the filter's own stage comes next, and ends at 100 per cent
  Surface surface;
};

/// Ends the run: log and values of everything so far, with what the filter found as `findings`.
void add_report(MeasuredMesh& measured, const char* title, const std::vector<std::string>& findings,
                FilterResult& result);

}  // namespace integral_invariant::filter
