// SPDX-License-Identifier: GPL-3.0-or-later
// The plugin that was built, loaded by Qt into MeshLab 2020.09's own library and applied to MeshLab's own meshes.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QPluginLoader>

#include <common/interfaces.h>
#include <vcg/complex/algorithms/update/curvature_integral_invariant.h>

#include <filesystem>

#include "registry.h"
#include "support/ply_file.h"
#include "support/shapes.h"

namespace {

using integral_invariant::Parameters;
using integral_invariant::Result;
using Update = vcg::tri::UpdateCurvatureIntegralInvariant<CMeshO>;

MeshFilterInterface* load_plugin()
{
  static QPluginLoader loader(PLUGIN_FILE);
  QObject* instance = loader.instance();
  EXPECT_NE(instance, nullptr) << loader.errorString().toStdString();
  return qobject_cast<MeshFilterInterface*>(instance);
}

bool obedient(const int, const char*) { return true; }
bool stubborn(const int percent, const char*) { return percent < 50; }

/// A unit sphere with a vertex and a face that are deleted, before those that count.
void add_sphere(MeshDocument& document, bool closed = true)
{
  MeshModel* model = document.addNewMesh("", "sphere");
  const integral_invariant::TriangleMesh sphere = test_support::icosphere(3);
  CMeshO& mesh = model->cm;
  vcg::tri::Allocator<CMeshO>::AddVertices(mesh, sphere.positions.size() + 1);
  vcg::tri::Allocator<CMeshO>::AddFaces(mesh, sphere.triangles.size() + 1);
  for (std::size_t v = 0; v < sphere.positions.size(); ++v) {
    const integral_invariant::Vec3& p = sphere.positions[v];
    mesh.vert[v + 1].P() = Point3m(Scalarm(p.x), Scalarm(p.y), Scalarm(p.z));
  }
  for (std::size_t f = 0; f < sphere.triangles.size(); ++f)
    for (int corner = 0; corner < 3; ++corner)
      mesh.face[f + 1].V(corner) = &mesh.vert[std::size_t(sphere.triangles[f][std::size_t(corner)]) + 1];
  for (int corner = 0; corner < 3; ++corner) mesh.face[0].V(corner) = &mesh.vert[0];
  vcg::tri::Allocator<CMeshO>::DeleteFace(mesh, mesh.face[0]);
  vcg::tri::Allocator<CMeshO>::DeleteVertex(mesh, mesh.vert[0]);
  if (!closed) vcg::tri::Allocator<CMeshO>::DeleteFace(mesh, mesh.face[1]);
  vcg::tri::UpdateBounding<CMeshO>::Box(mesh);
}

class Plugin : public testing::Test {
 protected:
  void SetUp() override
  {
    filter_ = load_plugin();
    ASSERT_NE(filter_, nullptr);
    ASSERT_EQ(std::size_t(filter_->actions().size()), integral_invariant::filter::all_filters().size());
    filter_->setLog(&log_);
  }

  QAction* action() { return filter_->actions().front(); }

  RichParameterList defaults(MeshDocument& document)
  {
    RichParameterList list;
    filter_->initParameterSet(action(), document, list);
    return list;
  }

  bool apply(MeshDocument& document, const RichParameterList& list, vcg::CallBackPos* callback = obedient)
  {
    return filter_->applyFilter(action(), document, list, callback);
  }

  /// The filter refuses with a sentence that holds `part`, and leaves the mesh without anything new.
  void expect_refusal(MeshDocument& document, const RichParameterList& list, const std::string& part,
                      vcg::CallBackPos* callback = obedient)
  {
    const CMeshO& mesh = document.mm()->cm;
    EXPECT_FALSE(apply(document, list, callback));
    EXPECT_NE(filter_->errorMsg().toStdString().find(part), std::string::npos) << filter_->errorMsg().toStdString();
    EXPECT_FALSE(document.mm()->hasDataMask(MeshModel::MM_VERTCURVDIR));
    EXPECT_FALSE(document.mm()->hasDataMask(MeshModel::MM_VERTQUALITY));
    EXPECT_FALSE(vcg::tri::HasPerVertexAttribute(mesh, std::string("ii_kmax")));
  }

  MeshFilterInterface* filter_ = nullptr;
  GLLogStream log_;
};

TEST_F(Plugin, SaysWhatItIs)
{
  EXPECT_EQ(filter_->filterName(action()), "Compute Curvature by Integral Invariants per Vertex");
  EXPECT_TRUE(filter_->getClass(action()) & MeshFilterInterface::Normal);
  EXPECT_TRUE(filter_->getClass(action()) & MeshFilterInterface::VertexColoring);
  EXPECT_TRUE(filter_->filterInfo(action()).contains("Lai"));
}

TEST_F(Plugin, FiltersOfFeaturesListTheirParametersAndRefuseWithoutAMesh)
{
  for (QAction* feature : filter_->actions()) {
    const auto& filter = *integral_invariant::filter::all_filters().at(std::size_t(filter_->ID(feature)));
    EXPECT_EQ(filter_->filterName(feature), filter.name);
    MeshDocument document;
    RichParameterList list;
    filter_->initParameterSet(feature, document, list);
    EXPECT_EQ(std::size_t(list.size()), filter.parameters.size());
    EXPECT_FALSE(filter_->applyFilter(feature, document, list, obedient));
  }
}

TEST_F(Plugin, SelectsFeaturesAroundDeletedElements)
{
  MeshDocument document;
  add_sphere(document);
  QAction* feature = filter_->actions()[1];
  RichParameterList list;
  filter_->initParameterSet(feature, document, list);
  list.setValue("threshold", EnumValue(1));
  list.setValue("high_curvature", FloatValue(0.5));
  ASSERT_TRUE(filter_->applyFilter(feature, document, list, obedient)) << filter_->errorMsg().toStdString();
  const CMeshO& mesh = document.mm()->cm;
  for (std::size_t v = 1; v < mesh.vert.size(); ++v) EXPECT_TRUE(mesh.vert[v].IsS());
  for (std::size_t f = 1; f < mesh.face.size(); ++f) EXPECT_TRUE(mesh.face[f].IsS());
}

TEST_F(Plugin, NewLayersStandWhereTheMeshStands)
{
  MeshDocument document;
  add_sphere(document);
  CMeshO& mesh = document.mm()->cm;
  for (auto& vertex : mesh.vert) vertex.P()[0] *= 2;
  mesh.Tr.SetTranslate(Point3m(1, 2, 3));
  const Matrix44m transform = mesh.Tr;
  QAction* feature = filter_->actions()[3];
  RichParameterList list;
  filter_->initParameterSet(feature, document, list);
  ASSERT_TRUE(filter_->applyFilter(feature, document, list, obedient)) << filter_->errorMsg().toStdString();
  ASSERT_EQ(document.meshList.size(), 2);
  const MeshModel& layer = *document.meshList[1];
  EXPECT_EQ(layer.cm.Tr, transform);
  EXPECT_GT(layer.cm.en, 100);
  EXPECT_FALSE(layer.cm.bbox.IsNull());
  EXPECT_TRUE(vcg::tri::HasPerVertexAttribute(layer.cm, std::string("ii_line")));
}

TEST_F(Plugin, ListsItsParametersWithoutAMesh)
{
  MeshDocument document;
  EXPECT_EQ(std::size_t(defaults(document).size()), integral_invariant::filter::curvature_filter().parameters.size());
  EXPECT_FALSE(apply(document, defaults(document)));
}

TEST_F(Plugin, WritesWhatTheCoreComputes)
{
  MeshDocument document;
  add_sphere(document);
  MeshModel& model = *document.mm();
  Parameters parameters;
  parameters.scales = 4;
  const Result expected = integral_invariant::compute_curvature(Update::CopyMesh(model.cm), parameters);

  RichParameterList list = defaults(document);
  list.setValue("scales", IntValue(4));
  ASSERT_TRUE(apply(document, list)) << filter_->errorMsg().toStdString();

  EXPECT_TRUE(model.cm.vert[0].IsD());
  EXPECT_EQ(std::size_t(model.cm.vn), expected.kappa_max.size());
  for (int mask :
       {MeshModel::MM_VERTCURVDIR, MeshModel::MM_VERTRADIUS, MeshModel::MM_VERTQUALITY, MeshModel::MM_VERTCOLOR})
    EXPECT_TRUE(model.hasDataMask(mask));
  auto kmax = vcg::tri::Allocator<CMeshO>::FindPerVertexAttribute<Scalarm>(model.cm, "ii_kmax");
  auto dirmin = vcg::tri::Allocator<CMeshO>::FindPerVertexAttribute<Point3m>(model.cm, "ii_dirmin");
  for (std::size_t v = 0; v < expected.kappa_max.size(); ++v) {
    CVertexO& vertex = model.cm.vert[v + 1];
    EXPECT_EQ(vertex.K1(), Scalarm(expected.kappa_max[v]));
    EXPECT_EQ(vertex.K2(), Scalarm(expected.kappa_min[v]));
    EXPECT_EQ(vertex.R(), Scalarm(expected.radius[v]));
    EXPECT_EQ(vertex.Q(), float((expected.kappa_max[v] + expected.kappa_min[v]) / 2));
    EXPECT_EQ(kmax[v + 1], Scalarm(expected.kappa_max[v]));
    EXPECT_EQ(dirmin[v + 1][0], Scalarm(expected.dir_min[v].x));
    EXPECT_EQ(vertex.PD1()[2], Scalarm(expected.dir_max[v].z));
  }
}

TEST_F(Plugin, LogsASummary)
{
  MeshDocument document;
  add_sphere(document);
  ASSERT_TRUE(apply(document, defaults(document)));
  QStringList lines;
  log_.print(lines);
  EXPECT_TRUE(lines.join('\n').contains("642 vertices"));
  EXPECT_TRUE(lines.join('\n').contains("Quality: mean curvature"));
}

TEST_F(Plugin, WithoutColourItLeavesTheColours)
{
  MeshDocument document;
  add_sphere(document);
  document.mm()->cm.vert[5].C() = vcg::Color4b(1, 2, 3, 4);
  RichParameterList list = defaults(document);
  list.setValue("colorize", BoolValue(false));
  ASSERT_TRUE(apply(document, list));
  EXPECT_EQ(document.mm()->cm.vert[5].C(), vcg::Color4b(1, 2, 3, 4));
}

TEST_F(Plugin, ExportsAFile)
{
  const std::string file = testing::TempDir() + "plugin_test.ply";
  MeshDocument document;
  add_sphere(document);
  RichParameterList list = defaults(document);
  list.setValue("export_file", FileValue(QString::fromStdString(file)));
  ASSERT_TRUE(apply(document, list)) << filter_->errorMsg().toStdString();
  EXPECT_GT(std::filesystem::file_size(file), 642u * 56u);
  std::filesystem::remove(file);
}

TEST_F(Plugin, ExportKeepsWhatTheMeshHadBeside)
{
  const std::string file = testing::TempDir() + "plugin_test_extras.ply";
  MeshDocument document;
  add_sphere(document);
  MeshModel& model = *document.mm();
  CMeshO& mesh = model.cm;
  model.updateDataMask(MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTTEXCOORD |
                       MeshModel::MM_WEDGTEXCOORD | MeshModel::MM_FACECOLOR);
  auto temperature = vcg::tri::Allocator<CMeshO>::AddPerVertexAttribute<Scalarm>(mesh, "temperature");
  auto velocity = vcg::tri::Allocator<CMeshO>::AddPerVertexAttribute<Point3m>(mesh, "velocity");
  for (std::size_t i = 0; i < mesh.vert.size(); ++i) {
    CVertexO& v = mesh.vert[i];
    v.C() = vcg::Color4b(static_cast<unsigned char>(i % 250), 2, 3, 255);
    v.Q() = 10 * float(i);
    v.T().U() = float(i) / 1024;
    v.N() = Point3m(0, 0, Scalarm(i));
    temperature[v] = Scalarm(i) + 1;
    velocity[v] = Point3m(0, Scalarm(i), 0);
  }
  for (std::size_t i = 0; i < mesh.face.size(); ++i)
    mesh.face[i].C() = vcg::Color4b(7, 8, static_cast<unsigned char>(i % 250), 255);
  mesh.textures.push_back("skin.png");

  RichParameterList list = defaults(document);
  list.setValue("export_file", FileValue(QString::fromStdString(file)));
  ASSERT_TRUE(apply(document, list)) << filter_->errorMsg().toStdString();
  const test_support::PlyFile content = test_support::read_ply(file);
  std::filesystem::remove(file);
  for (std::size_t i = 1; i < mesh.vert.size(); ++i) {  // the first vertex is deleted
    const std::size_t v = i - 1;
    EXPECT_EQ(content.property("original_red")[v], double(i % 250));
    EXPECT_EQ(content.property("original_quality")[v], 10 * double(i));
    EXPECT_EQ(content.property("s")[v], double(i) / 1024);
    EXPECT_EQ(content.property("nz")[v], double(i));
    EXPECT_EQ(content.property("temperature")[v], double(i) + 1);
    EXPECT_EQ(content.property("velocity_y")[v], double(i));
    EXPECT_EQ(float(content.property("quality")[v]), mesh.vert[i].Q());
  }
  EXPECT_EQ(content.triangles.size(), std::size_t(mesh.fn));
}

TEST_F(Plugin, BadValuesFromAScriptAreRefused)
{
  MeshDocument document;
  add_sphere(document);
  RichParameterList list = defaults(document);
  list.setValue("alpha", FloatValue(0));
  expect_refusal(document, list, "'alpha' is 0");
  list = defaults(document);
  list.setValue("quality", EnumValue(8));
  expect_refusal(document, list, "'quality' is 8");
  list = defaults(document);
  list.setValue("r_min", AbsPercValue(-1));
  expect_refusal(document, list, "'r_min' is -1");
  list = defaults(document);
  list.setValue("export_file", FileValue("/no such folder/out.ply"));
  expect_refusal(document, list, "/no such folder/out.ply");
}

TEST_F(Plugin, MeshesItCannotMeasureAreRefused)
{
  MeshDocument document;
  add_sphere(document, false);
  RichParameterList voxels = defaults(document);
  voxels.setValue("engine", EnumValue(0));
  expect_refusal(document, voxels, "boundary edges");
  for (CFaceO& face : document.mm()->cm.face)
    if (!face.IsD()) vcg::tri::Allocator<CMeshO>::DeleteFace(document.mm()->cm, face);
  EXPECT_FALSE(apply(document, defaults(document)));
}

TEST_F(Plugin, MeasuresAnOpenMeshByDefault)
{
  MeshDocument document;
  add_sphere(document, false);
  EXPECT_TRUE(apply(document, defaults(document))) << filter_->errorMsg().toStdString();
}

TEST_F(Plugin, ObeysACallbackThatSaysStop)
{
  MeshDocument document;
  add_sphere(document);
  expect_refusal(document, defaults(document), "cancelled", stubborn);
}

}  // namespace

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  QCoreApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
