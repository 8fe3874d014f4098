// SPDX-License-Identifier: GPL-3.0-or-later
// The filter as a plugin of MeshLab 2021.05 to 2025.07, and of PyMeshLab.
#ifndef FILTER_FEATURE_ADAPTED_II_API_2021_05_H
#define FILTER_FEATURE_ADAPTED_II_API_2021_05_H

#include <common/plugins/interfaces/filter_plugin.h>

class FilterFeatureAdaptedIIPlugin : public QObject, public FilterPlugin {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(FILTER_PLUGIN_IID)
  Q_INTERFACES(FilterPlugin)

 public:
  FilterFeatureAdaptedIIPlugin();

  QString pluginName() const override;
  QString vendor() const override;
  QString filterName(ActionIDType filter) const override;
  QString pythonFilterName(ActionIDType filter) const override;
  QString filterInfo(ActionIDType filter) const override;
  FilterClass getClass(const QAction* action) const override;
  FilterArity filterArity(const QAction* action) const override;
  int getPreConditions(const QAction* action) const override;
  int postCondition(const QAction* action) const override;

  using FilterPlugin::initParameterList;
  /// Works without a mesh too.
  RichParameterList initParameterList(const QAction* action, const MeshDocument& document) override;
  RichParameterList initParameterList(const QAction* action, const MeshModel& mesh) override;
  std::map<std::string, QVariant> applyFilter(const QAction* action, const RichParameterList& parameters,
                                              MeshDocument& document, unsigned int& postConditionMask,
                                              vcg::CallBackPos* callback) override;
};

#endif
