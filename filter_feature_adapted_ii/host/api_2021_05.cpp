// SPDX-License-Identifier: GPL-3.0-or-later
#include "api_2021_05.h"

#include "../filter_body.h"
#include "../help_text.h"
#include "rich_parameters.h"

namespace ii = integral_invariant::filter;

namespace {

/// The summary as PyMeshLab's apply_filter() returns it.
std::map<std::string, QVariant> output_map(const ii::Outcome& outcome)
{
	std::map<std::string, QVariant> map;
	const auto to_variant = [](const auto& value) {
		if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>) return QVariant(QString::fromStdString(value));
		else return QVariant(value);
	};
	for (const auto& [name, value] : ii::summary_values(outcome)) map[name] = std::visit(to_variant, value);
	return map;
}

} // namespace

FilterFeatureAdaptedIIPlugin::FilterFeatureAdaptedIIPlugin()
{
	typeList = {FP_CURVATURE_INTEGRAL_INVARIANT};
	for (ActionIDType type : types())
		actionList.push_back(new QAction(filterName(type), this));
}

QString FilterFeatureAdaptedIIPlugin::pluginName() const { return ii::plugin_name; }
QString FilterFeatureAdaptedIIPlugin::vendor() const { return ii::plugin_name; }
QString FilterFeatureAdaptedIIPlugin::filterName(ActionIDType) const { return ii::filter_name; }
QString FilterFeatureAdaptedIIPlugin::pythonFilterName(ActionIDType) const { return ii::python_name; }
QString FilterFeatureAdaptedIIPlugin::filterInfo(ActionIDType) const { return ii::help_text; }

FilterPlugin::FilterClass FilterFeatureAdaptedIIPlugin::getClass(const QAction*) const
{
	return FilterClass(Normal + VertexColoring);
}

FilterPlugin::FilterArity FilterFeatureAdaptedIIPlugin::filterArity(const QAction*) const { return SINGLE_MESH; }
int FilterFeatureAdaptedIIPlugin::getPreConditions(const QAction*) const { return MeshModel::MM_FACENUMBER; }
int FilterFeatureAdaptedIIPlugin::postCondition(const QAction*) const { return ii::written_fields(); }

RichParameterList FilterFeatureAdaptedIIPlugin::initParameterList(const QAction*, const MeshDocument& document)
{
	RichParameterList list;
	ii::add_parameters(document.mm() ? document.mm()->cm.bbox.Diag() : 0, list);
	return list;
}

RichParameterList FilterFeatureAdaptedIIPlugin::initParameterList(const QAction*, const MeshModel& mesh)
{
	RichParameterList list;
	ii::add_parameters(mesh.cm.bbox.Diag(), list);
	return list;
}

std::map<std::string, QVariant> FilterFeatureAdaptedIIPlugin::applyFilter(
	const QAction*, const RichParameterList& parameters, MeshDocument& document, unsigned int& postConditionMask,
	vcg::CallBackPos* callback)
{
	try {
		MeshModel* mesh = document.mm();
		if (!mesh) throw integral_invariant::InputError("There is no mesh to measure.");
		const ii::Outcome outcome = ii::measure(mesh->cm, ii::read_request(parameters), ii::progress_of(callback));
		mesh->updateDataMask(ii::written_fields(outcome.colorize));
		ii::write_outcome(mesh->cm, outcome);
		postConditionMask = ii::written_fields(outcome.colorize);
		for (const std::string& line : ii::summary_lines(outcome)) log(line);
		return output_map(outcome);
	}
	catch (const std::exception& error) {
		throw MLException(ii::failure_text(error).c_str());
	}
	catch (...) {
		throw MLException("An unknown error stopped the filter.");
	}
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterFeatureAdaptedIIPlugin)
