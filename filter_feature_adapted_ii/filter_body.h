// SPDX-License-Identifier: GPL-3.0-or-later
// What the filter does, over any mesh type with MeshLab's fields and for either plugin interface: everything is
// computed and exported before the mesh is touched, so whatever fails leaves it as it was.
#pragma once

#include <string>

#include <vcg/complex/algorithms/update/curvature_integral_invariant.h>
#include <wrap/callback.h>

#include "integral_invariant/curvature.h"
#include "outcome.h"
#include "ply_export.h"

namespace integral_invariant::filter {

/// The host's callback, which may be null, as the core's; called from the calling thread only. The text carries the
/// percentage for hosts that show nothing else, and ends with `line_end` for the one that prints it as it is.
inline ProgressCallback progress_of(vcg::CallBackPos* callback, const char* line_end = "")
{
  if (!callback) return {};
  return [callback, line_end](int percent, const char* stage) {
    return callback(percent, (std::string(stage) + ": " + std::to_string(percent) + "%" + line_end).c_str());
  };
}

/// Measures `mesh` and writes the export file, if any. The mesh is only read; deleted elements are skipped.
/// \throw std::exception with a sentence for the user
template <class MeshType>
Outcome measure(const MeshType& mesh, const Request& request, const ProgressCallback& progress)
{
  const std::string& file = request.output.export_file;
  if (!file.empty()) require_writable(file);
  const TriangleMesh copy = vcg::tri::UpdateCurvatureIntegralInvariant<MeshType>::CopyMesh(mesh);
  Outcome outcome = make_outcome(compute_curvature(copy, request.method, progress), request.output);
  if (!file.empty()) outcome.exported = export_ply(copy, outcome, file);
  return outcome;
}

/// Writes curvatures, directions, radius, named attributes, quality and colour. The host has enabled the fields.
template <class MeshType>
void write_outcome(MeshType& mesh, const Outcome& outcome)
{
  using Update = vcg::tri::UpdateCurvatureIntegralInvariant<MeshType>;
  using Vertex = typename MeshType::VertexType;
  Update::Write(mesh, outcome.result);
  Update::ForEachVertexWithIndex(mesh, [&](Vertex& vertex, std::size_t v) {
    vertex.Q() = Update::template Representable<typename Vertex::QualityType>(outcome.quality[v]);
    if (!outcome.colorize) return;
    const Color color = outcome.color(v);
    vertex.C() = vcg::Color4b(color[0], color[1], color[2], 255);
  });
}

/// Reads every parameter of the filter's table from a host's parameter list, through its getters, which all hosts name
/// alike. \throw ParameterError
template <class ParameterList>
Request read_request(const ParameterList& list, FilterId filter = FilterId::curvature)
{
  Request request;
  for (const ParameterSpec& spec : parameter_table(filter)) {
    switch (spec.kind) {
      case Kind::boolean:
        store(spec, list.getBool(spec.name), request);
        break;
      case Kind::integer:
        store(spec, list.getInt(spec.name), request);
        break;
      case Kind::choice:
        store(spec, list.getEnum(spec.name), request);
        break;
      case Kind::real:
        store(spec, as_typed(list.getFloat(spec.name)), request);
        break;
      case Kind::length:
        store(spec, as_typed(list.getAbsPerc(spec.name)), request);
        break;
      case Kind::save_file:
        store_text(spec, list.getSaveFileName(spec.name).toStdString(), request);
        break;
    }
  }
  return request;
}

}  // namespace integral_invariant::filter
