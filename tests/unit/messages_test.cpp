// SPDX-License-Identifier: GPL-3.0-or-later
// docs/messages.md lists what the filters say when they refuse: each message is provoked here, and none is missing
// there.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <regex>
#include <set>
#include <sstream>

#include "filter_script.h"
#include "integral_invariant/drawing/sheet.h"
#include "integral_invariant/features/crest_lines.h"
#include "integral_invariant/features/curvature_lines.h"
#include "integral_invariant/features/ridges_valleys.h"
#include "integral_invariant/features/signature.h"
#include "integral_invariant/curvature.h"
#include "line_layer.h"
#include "ply_export.h"
#include "registry.h"
#include "support/full_disk.h"
#include "support/message_list.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace integral_invariant::filter;
using namespace test_support;

namespace {

using Action = std::function<void()>;

/// What `action` says when it refuses; empty where it does not.
std::string refusal(const Action& action)
{
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// Curvature of the mesh with the method's parameters changed.
Action curvature(
    const TriangleMesh& mesh, const std::function<void(Parameters&)>& change = [](Parameters&) {})
{
  return [=] {
    Parameters parameters;
    change(parameters);
    compute_curvature(mesh, parameters);
  };
}

Action feature(const Filter& filter, const std::function<void(Request&)>& change,
               const TriangleMesh& mesh = icosphere(2))
{
  return [=, &filter] {
    Request request;
    change(request);
    run_filter(filter, {mesh, request});
  };
}

TriangleMesh open_sphere()
{
  TriangleMesh mesh = icosphere(1);
  mesh.triangles.pop_back();
  return mesh;
}

TriangleMesh with_vertex(TriangleMesh mesh, Vec3 position)
{
  mesh.positions[0] = position;
  return mesh;
}

/// Two spheres of this size, the edge lengths of which are lost beside the distance between them.
TriangleMesh specks_far_apart()
{
  return joined(scaled(icosphere(1), 1e-13), translated(scaled(icosphere(1), 1e-13), {1, 0, 0}));
}

TriangleMesh in_single_precision(TriangleMesh mesh)
{
  for (Vec3& p : mesh.positions) p = {double(float(p.x)), double(float(p.y)), double(float(p.z))};
  return mesh;
}

std::vector<Action> about_the_mesh()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto voxels = [](Parameters& p) { p.engine = EngineKind::volume_fft; };
  TriangleMesh damaged = icosphere(1);
  damaged.triangles[3][1] = 4000;
  return {curvature({}),
          curvature(with_vertex(scaled(icosphere(1), 0), {})),
          curvature(damaged),
          curvature(scaled(icosphere(1), 1e150)),
          curvature(scaled(icosphere(1), 1e-150)),
          curvature(specks_far_apart()),
          curvature(in_single_precision(translated(torus(3, 1, 90, 30), {5e5, 5e6, 100}))),
          curvature(open_sphere(), voxels),
          curvature(with_vertex(icosphere(1), {nan, 0, 0}), voxels)};
}

std::vector<Action> about_parameters()
{
  const TriangleMesh sphere = icosphere(2);
  const auto fixed = [](Parameters& p) { p = published_method(), p.radius_choice = RadiusChoice::fixed; };
  const auto ridges = [](const std::function<void(RidgeValleyParameters&)>& change) {
    return feature(ridges_and_valleys_filter(), [=](Request& r) { change(r.part<RidgeValleyParameters>()); });
  };
  return {
      curvature(sphere, [](Parameters& p) { p.alpha = -1; }),
      [] {
        Request request;
        store_assignment(curvature_filter(), "alpha=-1", request);
      },
      curvature(sphere, [](Parameters& p) { p.estimator = Estimator::yang06; }),
      curvature(sphere, [](Parameters& p) { p.scales = 2; }),
      curvature(sphere, [](Parameters& p) { p.r_min = 0.5, p.r_max = 0.2; }),
      curvature(sphere, [=](Parameters& p) { fixed(p), p.radius = 1e-9; }),
      curvature(sphere, [](Parameters& p) { p.r_min = 0.5, p.r_max = 0.5001; }),
      curvature(sphere, [](Parameters& p) { p.engine = EngineKind::volume_fft, p.r_min = 0.01; }),
      curvature(sphere, [](Parameters& p) { p.noise = 1e9; }),
      ridges([](auto& p) { p.threshold = FeatureThreshold::curvature, p.high_curvature = 0; }),
      ridges([](auto& p) { p.threshold = FeatureThreshold::curvature, p.high_curvature = 1, p.low_curvature = 2; }),
      ridges([](auto& p) { p.high_percentile = 200; }),
      ridges([](auto& p) { p.high_percentile = 20, p.low_percentile = 30; }),
      ridges([](auto& p) { p.ridges = p.valleys = false; }),
      feature(crest_lines_filter(),
              [](Request& r) { r.part<CrestLineParameters>().ridges = r.part<CrestLineParameters>().valleys = false; }),
      feature(
          directions_filter(),
          [](Request& r) { r.part<DirectionParameters>().maximal = r.part<DirectionParameters>().minimal = false; }),
      feature(directions_filter(), [](Request& r) { r.part<DirectionParameters>().spacing = 1e-9; }),
      feature(directions_filter(),
              [](Request& r) { r.part<LayerOptions>().lift = std::numeric_limits<double>::quiet_NaN(); }),
      feature(crest_lines_filter(),
              [](Request& r) { r.part<LayerOptions>().lift = std::numeric_limits<double>::infinity(); }),
      feature(signature_filter(), [](Request& r) { r.part<OutputOptions>().color_percentile = 1e9; }),
      feature(crest_lines_filter(), [](Request& r) { r.part<CrestLineParameters>().smoothing_passes = 1000000; }),
      feature(directions_filter(), [](Request& r) { r.part<DirectionParameters>().smoothing_passes = 1000000; }),
      feature(signature_filter(), [](Request& r) { r.part<ReductionParameters>().scale = 50; }),
      [=] {
        reduce(compute_signature(sphere, {}), {SignatureQuantity::volume, Reduction::one_scale, 50, 2});
      },
      [=] {
        reduce(compute_signature(sphere, {}), {SignatureQuantity::volume, Reduction::p_norm, 1, 0});
      },
  };
}

/// With the volume engine, one radius and little memory.
Action voxels(const TriangleMesh& mesh, double radius, double cells_per_radius, std::size_t limit_mb)
{
  return curvature(mesh, [=](Parameters& p) {
    p = published_method();
    p.engine = EngineKind::volume_fft;
    p.scales = 1;
    p.r_min = radius, p.fft_cells_per_radius = cells_per_radius, p.memory_limit_mb = limit_mb;
  });
}

TriangleMesh needle()
{
  TriangleMesh mesh = icosphere(5);
  for (Vec3& p : mesh.positions) p.z *= 1000;
  return mesh;
}

Action lines(const std::function<void(LineDrawingParameters&)>& change)
{
  return [=] {
    LineDrawingParameters p;
    change(p);
    require_drawable(p);
  };
}

/// A sheet of a line of 100 mm, or of none.
Action sheet(const std::function<void(SheetParameters&)>& change, bool is_empty = false)
{
  return [=] {
    SheetParameters p;
    change(p);
    const std::vector<Vec3> ends{{0, 0, 0}, {100, 0, 0}};
    const SurfaceLine line{LineKind::contour, {{ends[0], {0, 0, 1}}, {ends[1], {0, 0, 1}}}, false};
    const DrawnView empty{side_view(Side::front), {}}, drawn{side_view(Side::front), {{line, true}}};
    make_sheet({is_empty ? empty : drawn}, ends, 1, 3, p);
  };
}

std::vector<Action> about_line_drawings()
{
  return {lines([](auto& p) { p.contours = p.boundaries = p.creases = p.suggestive_contours = false; }),
          [] {
            make_view("v", {0, 0, 0}, {0, 1, 0});
          },
          [] {
            make_view("v", {0, 1, 0}, {0, 2, 0});
          },
          [] { side_view(Side(side_count)); },
          lines([](auto& p) { p.sections = -1; }),
          lines([](auto& p) { p.significance = -1; }),
          lines([](auto& p) { p.minimum_length = -1; }),
          lines([](auto& p) { p.crease_angle = 0; }),
          lines([](auto& p) { p.hatching_spacing = -1; }),
          sheet([](auto&) {}, true),
          sheet([](auto& p) { p.scale = 10, p.paper = Paper::a4; }),
          sheet([](auto& p) { p.scale = 100; }),
          sheet([](auto& p) { p.scale = -1; }),
          sheet([](auto& p) { p.inner_width = 0; })};
}

std::vector<Action> about_memory()
{
  const TriangleMesh sphere = icosphere(6);
  return {curvature(sphere, [](Parameters& p) { p.memory_limit_mb = 1; }),
          feature(
              signature_filter(),
              [](Request& r) { r.part<Parameters>().scales = 1, r.part<Parameters>().memory_limit_mb = 7; }, sphere),
          feature(
              signature_filter(), [](Request& r) { r.part<Parameters>().memory_limit_mb = 1; }, sphere),
          feature(directions_filter(),
                  [](Request& r) {
                    r.part<DirectionParameters>().spacing = 0.0005, r.part<Parameters>().memory_limit_mb = 300;
                  }),
          voxels(needle(), 0.11 * average_edge_length(needle()), 30, 10),
          voxels(joined(icosphere(1), translated(icosphere(1), {1e7, 0, 0})), 0.06, 20, 300),
          voxels(icosphere(3), 0.5, 40, 20),
          [=] { compute_curvature(sphere, {}, [](int, const char*) { return false; }); }};
}

std::vector<Action> about_files()
{
  const auto exported = [](const std::string& path) { return [=] { export_ply(icosphere(2), PlyContents{}, path); }; };
  const std::string folder = std::filesystem::temp_directory_path().string();
  return {exported("/no such folder/a.ply"),
          [=] {
            const SmallFiles limit(1000);
            exported(folder + "/full.ply")();
          },
          exported(folder + "/" + std::string(300, 'a') + ".ply"), exported("/dev/null"),
          [=] { require_writable(folder); }};
}

std::vector<Action> about_scripts()
{
  return {[] {
            Request request;
            store_assignment(curvature_filter(), "alpha", request);
          },
          [] {
            Request request;
            store_assignment(curvature_filter(), "sugar=2", request);
          },
          [] { find_filter("Make Coffee"); },
          [] {
            Request request;
            store_assignment(curvature_filter(), "radius=1e39", request);
            filter_script(curvature_filter(), request);
          }};
}

/// Each action refuses with a listed message, and each listed message is that of an action.
void expect_all(const std::string& section, const std::vector<Action>& actions)
{
  const std::vector<std::string> listed = listed_messages(section);
  ASSERT_FALSE(listed.empty()) << section;
  std::set<std::string> met;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const std::string said = refusal(actions[i]);
    const auto found =
        std::find_if(listed.begin(), listed.end(), [&](const std::string& l) { return is_message(said, l); });
    ASSERT_NE(found, listed.end()) << section << ", action " << i << " says: '" << said << "'";
    met.insert(*found);
  }
  for (const std::string& message : listed) EXPECT_TRUE(met.count(message)) << "nothing provokes: " << message;
}

}  // namespace

TEST(Messages, AboutTheMeshAreListed) { expect_all("The filters: the mesh", about_the_mesh()); }
TEST(Messages, AboutParametersAreListed) { expect_all("The filters: parameters", about_parameters()); }
TEST(Messages, AboutLineDrawingsAreListed) { expect_all("The filters: line drawings", about_line_drawings()); }
TEST(Messages, AboutMemoryAreListed) { expect_all("The filters: memory", about_memory()); }
TEST(Messages, AboutTheFileAreListed) { expect_all("The filters: the file that they write", about_files()); }
TEST(Messages, OfTheScriptWriterAreListed) { expect_all("write_filter_script", about_scripts()); }

TEST(Messages, InTheSourcesAreAllListed)
{
  // The first words of what is thrown, as far as they stand in the throw itself.
  const std::regex thrown("(?:Input|Parameter|Memory)Error\\((?:std::string\\()?\\s*\"((?:[^\"\\\\]|\\\\.){12,})\"");
  const std::vector<std::string> listed = listed_messages("");
  int seen = 0;
  for (const char* folder : {"/vcg_ext", "/filter_feature_adapted_ii"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(II_SOURCE_FOLDER + std::string(folder))) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      std::stringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      const std::string source = text.str();
      for (std::sregex_iterator match(source.begin(), source.end(), thrown), end; match != end; ++match, ++seen) {
        const std::string words = std::regex_replace((*match)[1].str(), std::regex("\\\\\""), "\"");
        EXPECT_TRUE(std::any_of(listed.begin(), listed.end(), [&](const auto& l) { return l.rfind(words, 0) == 0; }))
            << entry.path() << ": " << words;
      }
    }
  EXPECT_GT(seen, 15);
}
