// SPDX-License-Identifier: GPL-3.0-or-later
#include "api_2020_09.h"

#include "../help_text.h"
#include "run_filter.h"

namespace ii = integral_invariant::filter;

namespace {

/// Our enumeration and FilterId count alike.
ii::FilterId filter_of(int type) { return static_cast<ii::FilterId>(type); }

}  // namespace

FilterFeatureAdaptedIIPlugin::FilterFeatureAdaptedIIPlugin()
{
  typeList << FP_CURVATURE_INTEGRAL_INVARIANT << FP_SELECT_RIDGES_VALLEYS << FP_CREST_LINES_LAYER
           << FP_PRINCIPAL_DIRECTION_LAYER << FP_INTEGRAL_INVARIANT_SIGNATURE;
  for (FilterIDType type : types()) actionList << new QAction(filterName(type), this);
}

QString FilterFeatureAdaptedIIPlugin::pluginName() const { return ii::plugin_name; }
QString FilterFeatureAdaptedIIPlugin::filterName(FilterIDType type) const
{
  return ii::filter_facts(filter_of(type)).name;
}

/// 2020.09's dialog neither scrolls nor is lower than its content: a wide text keeps its buttons on the screen.
QString FilterFeatureAdaptedIIPlugin::filterInfo(FilterIDType type) const
{
  return QString("<table width=\"1200\"><tr><td>%1</td></tr></table>").arg(ii::filter_facts(filter_of(type)).help);
}

QString FilterFeatureAdaptedIIPlugin::filterScriptFunctionName(FilterIDType type)
{
  return ii::filter_facts(filter_of(type)).python_name;
}

MeshFilterInterface::FilterClass FilterFeatureAdaptedIIPlugin::getClass(QAction* action)
{
  switch (ID(action)) {
    case FP_SELECT_RIDGES_VALLEYS:
      return FilterClass(Selection + VertexColoring);
    case FP_CREST_LINES_LAYER:
    case FP_PRINCIPAL_DIRECTION_LAYER:
      return FilterClass(Layer + Normal);
    case FP_INTEGRAL_INVARIANT_SIGNATURE:
      return FilterClass(Quality + VertexColoring);
    default:
      return FilterClass(Normal + VertexColoring);
  }
}

MeshFilterInterface::FILTER_ARITY FilterFeatureAdaptedIIPlugin::filterArity(QAction*) const { return SINGLE_MESH; }
int FilterFeatureAdaptedIIPlugin::getPreConditions(QAction*) const { return MeshModel::MM_FACENUMBER; }
int FilterFeatureAdaptedIIPlugin::postCondition(QAction* action) const
{
  return ii::written_fields(filter_of(ID(action)));
}

void FilterFeatureAdaptedIIPlugin::initParameterSet(QAction* action, MeshDocument& document,
                                                    RichParameterList& parameters)
{
  const MeshModel* mesh = document.mm();
  ii::add_parameters(filter_of(ID(action)), mesh ? mesh->cm.bbox.Diag() : 0, parameters);
}

/// Nothing is caught around this call in 2020.09, so nothing may leave it.
bool FilterFeatureAdaptedIIPlugin::applyFilter(QAction* action, MeshDocument& document,
                                               const RichParameterList& parameters, vcg::CallBackPos* callback)
{
  try {
    // meshlabserver prints the text without ending the line; the window draws the end of a line as a space.
    const ii::RunReport report =
        ii::run_filter(filter_of(ID(action)), document, parameters, ii::progress_of(callback, "\n"));
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
