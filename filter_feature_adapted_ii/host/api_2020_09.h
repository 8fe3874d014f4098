// SPDX-License-Identifier: GPL-3.0-or-later
// The filter as a plugin of MeshLab 2020.09.
#ifndef FILTER_FEATURE_ADAPTED_II_API_2020_09_H
#define FILTER_FEATURE_ADAPTED_II_API_2020_09_H

#include <QObject>
#include <common/interfaces.h>

class FilterFeatureAdaptedIIPlugin : public QObject, public MeshFilterInterface {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(MESH_FILTER_INTERFACE_IID)
  Q_INTERFACES(MeshFilterInterface)

 public:
  FilterFeatureAdaptedIIPlugin();

  QString pluginName() const override;
  QString filterName(FilterIDType filter) const override;
  QString filterInfo(FilterIDType filter) const override;
  QString filterScriptFunctionName(FilterIDType filter) override;
  FilterClass getClass(QAction* action) override;
  FILTER_ARITY filterArity(QAction* action) const override;
  int getPreConditions(QAction* action) const override;
  int postCondition(QAction* action) const override;

  using MeshFilterInterface::initParameterSet;
  /// Works without a mesh too: meshlabserver asks for the parameters before it has loaded one.
  void initParameterSet(QAction* action, MeshDocument& document, RichParameterList& parameters) override;
  bool applyFilter(QAction* action, MeshDocument& document, const RichParameterList& parameters,
                   vcg::CallBackPos* callback) override;
};

#endif
