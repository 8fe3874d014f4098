// SPDX-License-Identifier: GPL-3.0-or-later
#include "api_2020_09.h"

#include "../filter_body.h"
#include "../help_text.h"
#include "rich_parameters.h"

namespace ii = integral_invariant::filter;

FilterFeatureAdaptedIIPlugin::FilterFeatureAdaptedIIPlugin()
{
	typeList << FP_CURVATURE_INTEGRAL_INVARIANT;
	for (FilterIDType type : types())
		actionList << new QAction(filterName(type), this);
}

QString FilterFeatureAdaptedIIPlugin::pluginName() const { return ii::plugin_name; }
QString FilterFeatureAdaptedIIPlugin::filterName(FilterIDType) const { return ii::filter_name; }

/// 2020.09's dialog neither scrolls nor is lower than its content: a wide text keeps its buttons on the screen.
QString FilterFeatureAdaptedIIPlugin::filterInfo(FilterIDType) const
{
	return QString("<table width=\"940\"><tr><td>%1</td></tr></table>").arg(ii::help_text);
}

QString FilterFeatureAdaptedIIPlugin::filterScriptFunctionName(FilterIDType) { return ii::python_name; }

MeshFilterInterface::FilterClass FilterFeatureAdaptedIIPlugin::getClass(QAction*)
{
	return FilterClass(Normal + VertexColoring);
}

MeshFilterInterface::FILTER_ARITY FilterFeatureAdaptedIIPlugin::filterArity(QAction*) const { return SINGLE_MESH; }
int FilterFeatureAdaptedIIPlugin::getPreConditions(QAction*) const { return MeshModel::MM_FACENUMBER; }
int FilterFeatureAdaptedIIPlugin::postCondition(QAction*) const { return ii::written_fields(); }

void FilterFeatureAdaptedIIPlugin::initParameterSet(QAction*, MeshDocument& document, RichParameterList& parameters)
{
	const MeshModel* mesh = document.mm();
	ii::add_parameters(mesh ? mesh->cm.bbox.Diag() : 0, parameters);
}

/// Nothing is caught around this call in 2020.09, so nothing may leave it.
bool FilterFeatureAdaptedIIPlugin::applyFilter(
	QAction*, MeshDocument& document, const RichParameterList& parameters, vcg::CallBackPos* callback)
{
	try {
		MeshModel* mesh = document.mm();
		if (!mesh) throw integral_invariant::InputError("There is no mesh to measure.");
		// meshlabserver prints the text without ending the line; the window draws the end of a line as a space.
		const ii::Outcome outcome = ii::measure(mesh->cm, ii::read_request(parameters), ii::progress_of(callback, "\n"));
		mesh->updateDataMask(ii::written_fields(outcome.colorize));
		ii::write_outcome(mesh->cm, outcome);
		for (const std::string& line : ii::summary_lines(outcome)) Log(line);
		return true;
	}
	catch (const std::exception& error) {
		errorMessage = ii::failure_text(error).c_str();
	}
	catch (...) {
		errorMessage = "An unknown error stopped the filter.";
	}
	Log(errorMessage.toStdString()); // meshlabserver prints the log, but not the message
	return false;
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterFeatureAdaptedIIPlugin)
