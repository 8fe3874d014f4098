// SPDX-License-Identifier: GPL-3.0-or-later
// The plugin in MeshLab 2020.09's own library where memory runs out while it adds a layer: the document is as it was.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QPluginLoader>

#include <common/interfaces.h>

#include <algorithm>
#include <tuple>

#include "registry.h"
#include "support/failing_allocation.h"
#include "support/shapes.h"

namespace {

using namespace integral_invariant::filter;
void add_torus(MeshDocument& document)
{
  const integral_invariant::TriangleMesh torus = test_support::torus(1, 0.4, 24, 12);
  CMeshO& mesh = document.addNewMesh("", "torus")->cm;
  for (const integral_invariant::Vec3& p : torus.positions)
    vcg::tri::Allocator<CMeshO>::AddVertex(mesh, Point3m(Scalarm(p.x), Scalarm(p.y), Scalarm(p.z)));
  for (const integral_invariant::Triangle& t : torus.triangles)
    vcg::tri::Allocator<CMeshO>::AddFace(mesh, std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2]));
  vcg::tri::UpdateBounding<CMeshO>::Box(mesh);
}

using LayerSize = std::tuple<int, int, std::size_t>;

/// Vertices, edges and attributes.
LayerSize size_of(const MeshModel& layer) { return {layer.cm.vn, layer.cm.en, layer.cm.vert_attr.size()}; }

class PluginMemory : public testing::Test {
 protected:
  PluginMemory() : loader_(PLUGIN_FILE), filter_(qobject_cast<MeshFilterInterface*>(loader_.instance()))
  {
    if (filter_) filter_->setLog(&log_);
  }

  /// Adds a layer of principal directions; whether memory that ends at the n-th allocation was enough.
  bool adds_layer(MeshDocument& document, long n)
  {
    const auto& filters = all_filters();
    const auto number = std::find(filters.begin(), filters.end(), &directions_filter()) - filters.begin();
    QAction* action = filter_->actions().at(int(number));
    RichParameterList parameters;
    filter_->initParameterSet(action, document, parameters);
    bool applied = false;
    test_support::runs_out_of_memory(n, [&] { applied = filter_->applyFilter(action, document, parameters, nullptr); });
    return applied;
  }

  QPluginLoader loader_;
  MeshFilterInterface* filter_;
  GLLogStream log_;
};

TEST_F(PluginMemory, NoLayerIsLeftUnfinished)
{
  ASSERT_NE(filter_, nullptr);
  MeshDocument document;
  add_torus(document);
  const int torus = document.mm()->id();
  const auto run = [&](long n) {
    while (document.meshList.size() > 1) document.delMesh(document.meshList.back());
    document.setCurrentMesh(torus);
    return adds_layer(document, n);
  };
  long enough = 1, little = 0;
  for (; !run(enough); enough *= 2) little = enough;
  while (enough - little > 1) {  // the least that is enough
    const long middle = (enough + little) / 2;
    (run(middle) ? enough : little) = middle;
  }
  ASSERT_TRUE(run(2 * enough));  // times in the log make the count vary a little
  ASSERT_EQ(document.meshList.size(), 2);
  const LayerSize whole = size_of(*document.mm());
  EXPECT_GT(std::get<1>(whole), 0);
  // The layer's vertices, edges and attributes are among the last allocations; then only the log can fail.
  constexpr long last = 150;
  int refused = 0;
  for (long n = enough - last; n < enough; ++n) {
    run(n);
    if (document.meshList.size() > 1) {
      ASSERT_EQ(size_of(*document.mm()), whole) << "allocation " << n << " of " << enough;
    } else {
      ASSERT_EQ(document.mm()->id(), torus) << n;
      ++refused;
    }
  }
  EXPECT_GT(refused, 50);
}

}  // namespace

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  const QCoreApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
