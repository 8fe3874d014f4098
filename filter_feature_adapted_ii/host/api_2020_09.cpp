// SPDX-License-Identifier: GPL-3.0-or-later
#include "api_2020_09.h"

#include "run.h"

namespace ii = integral_invariant::filter;

FilterFeatureAdaptedIIPlugin::FilterFeatureAdaptedIIPlugin()
{
  for (std::size_t type = 0; type < ii::all_filters().size(); ++type) typeList << FilterIDType(type);
  for (FilterIDType type : types()) actionList << new QAction(filterName(type), this);
}

QString FilterFeatureAdaptedIIPlugin::pluginName() const { return ii::plugin_name; }
QString FilterFeatureAdaptedIIPlugin::filterName(FilterIDType type) const { return ii::filter_of(type).name; }

/// 2020.09's dialog neither scrolls nor is lower than its content: a wide text keeps its buttons on the screen.
QString FilterFeatureAdaptedIIPlugin::filterInfo(FilterIDType type) const
{
  return QString("<table width=\"1200\"><tr><td>%1</td></tr></table>").arg(ii::filter_of(type).help);
}

QString FilterFeatureAdaptedIIPlugin::filterScriptFunctionName(FilterIDType type)
{
  return ii::filter_of(type).python_name;
}

MeshFilterInterface::FilterClass FilterFeatureAdaptedIIPlugin::getClass(QAction* action)
{
  return ii::filter_class<MeshFilterInterface>(ii::filter_of(ID(action)));
}

MeshFilterInterface::FILTER_ARITY FilterFeatureAdaptedIIPlugin::filterArity(QAction*) const { return SINGLE_MESH; }
int FilterFeatureAdaptedIIPlugin::getPreConditions(QAction*) const { return MeshModel::MM_FACENUMBER; }
int FilterFeatureAdaptedIIPlugin::postCondition(QAction* action) const
{
  return ii::data_mask(ii::filter_of(ID(action)).writes);
}

void FilterFeatureAdaptedIIPlugin::initParameterSet(QAction* action, MeshDocument& document,
                                                    RichParameterList& parameters)
{
  const MeshModel* mesh = document.mm();
  ii::add_parameters(ii::filter_of(ID(action)).parameters, mesh ? mesh->cm.bbox.Diag() : 0, parameters);
}

/// Nothing is caught around this call in 2020.09, so nothing may leave it.
bool FilterFeatureAdaptedIIPlugin::applyFilter(QAction* action, MeshDocument& document,
                                               const RichParameterList& parameters, vcg::CallBackPos* callback)
{
  try {
    // meshlabserver prints the text without ending the line; the window draws the end of a line as a space.
    const ii::RunReport report =
        ii::run_on_document(ii::filter_of(ID(action)), document, parameters, ii::progress_of(callback, "\n"));
    for (const std::string& line : report.log) Log(line);
    return true;
  } catch (const std::exception& error) {
    errorMessage = ii::failure_text(error).c_str();
  } catch (...) {
    errorMessage = "An unknown error stopped the filter. The mesh is unchanged.";
  }
  Log(errorMessage.toStdString());  // meshlabserver prints the log, but not the message
  return false;
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterFeatureAdaptedIIPlugin)
