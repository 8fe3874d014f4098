// SPDX-License-Identifier: GPL-3.0-or-later
// What both plugin interfaces do to run a filter: measure the current mesh, then write to it or to a new layer.
// Everything is computed and exported before a mesh is touched, so whatever fails leaves the document as it was.
#pragma once

#include <new>
#include <string>
#include <utility>
#include <vector>

#include <vcg/complex/algorithms/update/selection.h>
#include <wrap/callback.h>

#include "../mesh_extras.h"
#include "../ply_export.h"
#include "../registry.h"
#include "../write_result.h"
#include "rich_parameters.h"

namespace integral_invariant::filter {

/// The filter that the host knows by that number.
inline const Filter& filter_of(int type) { return *all_filters().at(std::size_t(type)); }

/// The host's places in the menu. Plugin: the base class of filters, which names them.
template <class Plugin>
typename Plugin::FilterClass filter_class(const Filter& filter)
{
  const std::pair<Menu, int> places[] = {{menu_selection, Plugin::Selection},
                                         {menu_layers, Plugin::Layer},
                                         {menu_quality, Plugin::Quality},
                                         {menu_normals_and_curvature, Plugin::Normal},
                                         {menu_vertex_colors, Plugin::VertexColoring}};
  int all = 0;
  for (const auto& [menu, place] : places)
    if (filter.menus & menu) all |= place;
  return typename Plugin::FilterClass(all);
}

/// The host's mask of fields of MeshField.
inline int data_mask(unsigned fields)
{
  const std::pair<MeshField, int> masks[] = {
      {field_curvature, MeshModel::MM_VERTCURVDIR},
      {field_radius, MeshModel::MM_VERTRADIUS},
      {field_quality, MeshModel::MM_VERTQUALITY},
      {field_color, MeshModel::MM_VERTCOLOR},
      {field_selection, MeshModel::MM_VERTFLAGSELECT | MeshModel::MM_FACEFLAGSELECT}};
  int all = MeshModel::MM_NONE;
  for (const auto& [field, mask] : masks)
    if (fields & field) all |= mask;
  return all;
}

/// The host's callback, which may be null, as the core's; called from the calling thread only. The text carries the
/// percentage for hosts that show nothing else, and ends with `line_end` for the one that prints it as it is.
inline ProgressCallback progress_of(vcg::CallBackPos* callback, const char* line_end = "")
{
  if (!callback) return {};
  return [callback, line_end](int percent, const char* stage) {
    return callback(percent, (std::string(stage) + ": " + std::to_string(percent) + "%" + line_end).c_str());
  };
}

/// A sentence for the user.
inline std::string failure_text(const std::exception& error)
{
  if (dynamic_cast<const std::bad_alloc*>(&error))
    return "There is not enough memory. Use fewer scales, fewer cells per radius, or a larger smallest radius. The "
           "mesh is unchanged.";
  return error.what();
}

/// What the user's mesh has beside its shape.
inline MeshExtras extras_of(const MeshModel& model)
{
  return mesh_extras(model.cm,
                     {model.hasDataMask(MeshModel::MM_VERTCOLOR), model.hasDataMask(MeshModel::MM_VERTQUALITY)});
}

/// Runs the filter on the mesh, which is only read (deleted elements are skipped), and writes the export file, if any.
inline FilterResult measure(const Filter& filter, const MeshModel& model, const Request& request,
                            const ProgressCallback& progress)
{
  const std::string& file = request.part<OutputOptions>().export_file;
  if (!file.empty()) require_writable(file);
  const TriangleMesh copy = vcg::tri::UpdateCurvatureIntegralInvariant<CMeshO>::CopyMesh(model.cm);
  FilterResult result = run_filter(filter, {copy, request}, progress);
  const std::string exported = file.empty()          ? ""
                               : result.file.empty() ? export_ply(copy, result, file, extras_of(model))
                                                     : export_bytes(result.file, file);
  if (!exported.empty()) result.log.push_back("Exported: " + exported);
  result.values.emplace_back("exported", exported);
  return result;
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

/// What a run has to say.
struct RunReport {
  std::vector<std::string> log;
  std::vector<std::pair<std::string, SummaryValue>> values;
  int written = 0;  ///< fields of the current mesh
};

/// Runs a filter on the current mesh of the document. \throw std::exception with a sentence for the user
inline RunReport run_on_document(const Filter& filter, MeshDocument& document, const RichParameterList& parameters,
                                 const ProgressCallback& progress)
{
  MeshModel* model = document.mm();
  if (!model) throw InputError("There is no mesh to measure: open one first.");
  const FilterResult result = measure(filter, *model, read_request(filter.parameters, parameters), progress);
  RunReport report{result.log, result.values, data_mask(written_fields(result))};
  model->updateDataMask(report.written);
  write_result(model->cm, result);
  if (!result.selection.empty()) {  // later steps of a script ask for the counts, which only the window renews
    model->cm.svn = int(vcg::tri::UpdateSelection<CMeshO>::VertexCount(model->cm));
    model->cm.sfn = int(vcg::tri::UpdateSelection<CMeshO>::FaceCount(model->cm));
  }
  if (result.lines) add_layer(document, *result.lines);
  return report;
}

}  // namespace integral_invariant::filter
