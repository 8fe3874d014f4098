// SPDX-License-Identifier: GPL-3.0-or-later
#include "api_2021_05.h"

#include "pymeshlab_log.h"
#include "run.h"

namespace ii = integral_invariant::filter;

namespace {

[[noreturn]] void fail(const std::string& sentence)
{
  ii::make_pymeshlab_forget_its_log();
  throw MLException(sentence.c_str());
}

/// The summary as PyMeshLab's apply_filter() returns it.
std::map<std::string, QVariant> output_map(const ii::RunReport& report)
{
  std::map<std::string, QVariant> map;
  const auto to_variant = [](const auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>)
      return QVariant(QString::fromStdString(value));
    else
      return QVariant(value);
  };
  for (const auto& [name, value] : report.values) map[name] = std::visit(to_variant, value);
  return map;
}

}  // namespace

FilterFeatureAdaptedIIPlugin::FilterFeatureAdaptedIIPlugin()
{
  for (std::size_t type = 0; type < ii::all_filters().size(); ++type) typeList.push_back(ActionIDType(type));
  for (ActionIDType type : types()) actionList.push_back(new QAction(filterName(type), this));
}

QString FilterFeatureAdaptedIIPlugin::pluginName() const { return ii::plugin_name; }
QString FilterFeatureAdaptedIIPlugin::vendor() const { return ii::plugin_name; }
QString FilterFeatureAdaptedIIPlugin::filterName(ActionIDType type) const { return ii::filter_of(type).name; }
QString FilterFeatureAdaptedIIPlugin::pythonFilterName(ActionIDType type) const
{
  return ii::filter_of(type).python_name;
}
QString FilterFeatureAdaptedIIPlugin::filterInfo(ActionIDType type) const { return ii::filter_of(type).help; }

FilterPlugin::FilterClass FilterFeatureAdaptedIIPlugin::getClass(const QAction* action) const
{
  return ii::filter_class<FilterPlugin>(ii::filter_of(ID(action)));
}

FilterPlugin::FilterArity FilterFeatureAdaptedIIPlugin::filterArity(const QAction*) const { return SINGLE_MESH; }
// What a mesh lacks, the filter says in a better sentence than "the mesh has no Any Faces".
int FilterFeatureAdaptedIIPlugin::getPreConditions(const QAction*) const { return MeshModel::MM_NONE; }
int FilterFeatureAdaptedIIPlugin::postCondition(const QAction* action) const
{
  return ii::data_mask(ii::filter_of(ID(action)).writes);
}

RichParameterList FilterFeatureAdaptedIIPlugin::initParameterList(const QAction* action, const MeshDocument& document)
{
  RichParameterList list;
  ii::add_parameters(ii::filter_of(ID(action)).parameters, document.mm() ? document.mm()->cm.bbox.Diag() : 0, list);
  return list;
}

RichParameterList FilterFeatureAdaptedIIPlugin::initParameterList(const QAction* action, const MeshModel& mesh)
{
  RichParameterList list;
  ii::add_parameters(ii::filter_of(ID(action)).parameters, mesh.cm.bbox.Diag(), list);
  return list;
}

std::map<std::string, QVariant> FilterFeatureAdaptedIIPlugin::applyFilter(const QAction* action,
                                                                          const RichParameterList& parameters,
                                                                          MeshDocument& document,
                                                                          unsigned int& postConditionMask,
                                                                          vcg::CallBackPos* callback)
{
  try {
    const ii::RunReport report =
        ii::run_on_document(ii::filter_of(ID(action)), document, parameters, ii::progress_of(callback));
    postConditionMask = unsigned(report.written);
    for (const std::string& line : report.log) log(line);
    return output_map(report);
  } catch (const std::exception& error) {
    fail(ii::failure_text(error));
  } catch (...) {
    fail("An unknown error stopped the filter. The mesh is unchanged.");
  }
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterFeatureAdaptedIIPlugin)
