// SPDX-License-Identifier: GPL-3.0-or-later
// What both plugin interfaces do to run a filter: measure the current mesh, then write to it or to a new layer.
#pragma once

#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/algorithms/update/selection.h>

#include "../feature_body.h"
#include "../filters.h"
#include "rich_parameters.h"

namespace integral_invariant::filter {

/// What a run has to say.
struct RunReport {
  std::vector<std::string> log;
  std::vector<std::pair<std::string, SummaryValue>> values;
  int written = 0;  ///< fields of the current mesh
};

/// The fields of the current mesh that a filter may write.
inline int written_fields(FilterId filter)
{
  switch (filter) {
    case FilterId::curvature:
      return written_fields();
    case FilterId::ridges_and_valleys:
      return MeshModel::MM_VERTFLAGSELECT | MeshModel::MM_FACEFLAGSELECT | MeshModel::MM_VERTCOLOR;
    case FilterId::signature:
      return MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR;
    case FilterId::crest_lines:
    case FilterId::principal_directions:
      break;
  }
  return MeshModel::MM_NONE;
}

inline RunReport run_curvature(MeshModel& model, const Request& request, const ProgressCallback& progress)
{
  const Outcome outcome = measure(model.cm, request, progress);
  RunReport report{summary_lines(outcome), summary_values(outcome), written_fields(outcome.colorize)};
  model.updateDataMask(report.written);
  write_outcome(model.cm, outcome);
  return report;
}

/// Takes a layer out of the document. By its address in 2020.09, by its number in later releases.
template <class Document, class Model>
auto remove_layer(Document& document, Model* layer) -> decltype(document.delMesh(layer), void())
{
  document.delMesh(layer);
}
template <class Document, class Model>
auto remove_layer(Document& document, Model* layer) -> decltype(document.delMesh(layer->id()), void())
{
  document.delMesh(layer->id());
}

/// Adds the lines as the current layer; where memory runs out, the document is left as it was.
inline void add_layer(MeshDocument& document, const LineLayer& lines)
{
  const MeshModel& source = *document.mm();
  MeshModel* layer = document.addNewMesh(QString(), QString::fromStdString(lines.label));
  try {
    layer->updateDataMask(MeshModel::MM_VERTQUALITY |
                          (lines.colors.empty() ? MeshModel::MM_NONE : MeshModel::MM_VERTCOLOR));
    fill_with_lines(layer->cm, lines);
    layer->cm.Tr = source.cm.Tr;
  } catch (...) {
    remove_layer(document, layer);
    document.setCurrentMesh(source.id());
    throw;
  }
}

inline RunReport run_feature(FilterId filter, MeshDocument& document, const Request& request,
                             const ProgressCallback& progress)
{
  MeshModel& model = *document.mm();
  const FeatureOutcome outcome = measure_feature(filter, model.cm, request, progress);
  RunReport report{outcome.log, outcome.values, MeshModel::MM_NONE};
  report.values.emplace_back("exported", outcome.exported);
  if (!outcome.selection.empty()) report.written |= MeshModel::MM_VERTFLAGSELECT | MeshModel::MM_FACEFLAGSELECT;
  if (!outcome.quality.empty()) report.written |= MeshModel::MM_VERTQUALITY;
  if (!outcome.colors.empty()) report.written |= MeshModel::MM_VERTCOLOR;
  model.updateDataMask(report.written);
  write_feature(model.cm, outcome);
  if (!outcome.selection.empty()) {  // later steps of a script ask for the counts, which only the window renews
    model.cm.svn = int(vcg::tri::UpdateSelection<CMeshO>::VertexCount(model.cm));
    model.cm.sfn = int(vcg::tri::UpdateSelection<CMeshO>::FaceCount(model.cm));
  }
  if (outcome.lines) add_layer(document, *outcome.lines);
  return report;
}

/// Runs a filter on the current mesh of the document. \throw std::exception with a sentence for the user
inline RunReport run_filter(FilterId filter, MeshDocument& document, const RichParameterList& parameters,
                            const ProgressCallback& progress)
{
  MeshModel* mesh = document.mm();
  if (!mesh) throw InputError("There is no mesh to measure: open one first.");
  const Request request = read_request(parameters, filter);
  if (filter == FilterId::curvature) return run_curvature(*mesh, request, progress);
  return run_feature(filter, document, request, progress);
}

}  // namespace integral_invariant::filter
