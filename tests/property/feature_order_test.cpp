// SPDX-License-Identifier: GPL-3.0-or-later
// The order of vertices, faces and corners, and the number of threads, change no bit of what the filters for features
// leave.
#include <gtest/gtest.h>

#include <string>

#include "integral_invariant/features/crest_lines.h"
#include "integral_invariant/features/curvature_lines.h"
#include "integral_invariant/parameters.h"
#include "registry.h"
#include "support/feature_shapes.h"
#include "support/shuffle.h"

namespace integral_invariant::filter {
namespace {

using test_support::ShuffledMesh;

TriangleMesh closed_mesh()
{
  return test_support::with_tangential_jitter(
      test_support::with_normal_noise(test_support::ellipsoid(3, {2, 1.4, 0.8}), 0.002), 0.02);
}

/// With a boundary, vertices that no face uses, and repeated faces.
TriangleMesh open_mesh()
{
  TriangleMesh mesh = closed_mesh();
  mesh.triangles.resize(mesh.triangles.size() * 3 / 4);
  mesh.triangles.insert(mesh.triangles.end(), {mesh.triangles[5], mesh.triangles[50]});
  return mesh;
}

/// Without noise, and the same everywhere around: whatever can tie does.
TriangleMesh smooth_mesh() { return test_support::torus(2, 0.6, 60, 18); }

struct Case {
  const char* name;
  const Filter& (*filter)();
  TriangleMesh (*mesh)();
};

class FeatureOrder : public testing::TestWithParam<Case> {};

/// Of the styles that principal directions have.
constexpr double traced = 0, segments = 1;

FilterResult result_of(const Filter& filter, const TriangleMesh& mesh, int threads, double style)
{
  Request request;
  request.part<Parameters>().threads = threads;
  request.part<CrestLineParameters>().minimum_strength = 0.1;
  request.part<CrestLineParameters>().minimum_sharpness = 0.1;
  request.part<DirectionParameters>().minimal = true;
  if (const ParameterSpec* spec = find_parameter(filter.parameters, "style")) store(*spec, style, request);
  return run_filter(filter, {mesh, request});
}

void expect_same_bits(const FilterResult& a, const FilterResult& b, const ShuffledMesh& order)
{
  if (!a.selection.empty()) { EXPECT_EQ(a.selection, order.back(b.selection)); }
  if (!a.quality.empty()) { EXPECT_EQ(a.quality, order.back(b.quality)); }
  if (!a.colors.empty()) { EXPECT_EQ(a.colors, order.back(b.colors)); }
  ASSERT_EQ(a.attributes.size(), b.attributes.size());
  for (std::size_t i = 0; i < a.attributes.size(); ++i)
    EXPECT_EQ(a.attributes[i].values, order.back(b.attributes[i].values));
  ASSERT_EQ(a.lines.has_value(), b.lines.has_value());
  if (!a.lines) return;
  EXPECT_FALSE(a.lines->edges.empty());
  EXPECT_TRUE(a.lines->positions == b.lines->positions);
  EXPECT_TRUE(a.lines->normals == b.lines->normals);
  EXPECT_EQ(a.lines->edges, b.lines->edges);
  EXPECT_EQ(a.lines->quality, b.lines->quality);
  EXPECT_EQ(a.lines->colors, b.lines->colors);
  for (std::size_t i = 0; i < a.lines->attributes.size(); ++i)
    EXPECT_EQ(a.lines->attributes[i].values, b.lines->attributes[i].values);
}

constexpr auto ridges = ridges_and_valleys_filter, crest = crest_lines_filter, directions = directions_filter,
               signature = signature_filter;

INSTANTIATE_TEST_SUITE_P(
    Filters, FeatureOrder,
    testing::Values(Case{"RidgesClosed", ridges, closed_mesh}, Case{"RidgesOpen", ridges, open_mesh},
                    Case{"RidgesSmooth", ridges, smooth_mesh}, Case{"CrestClosed", crest, closed_mesh},
                    Case{"CrestOpen", crest, open_mesh}, Case{"DirectionsClosed", directions, closed_mesh},
                    Case{"DirectionsOpen", directions, open_mesh}, Case{"DirectionsSmooth", directions, smooth_mesh},
                    Case{"SignatureClosed", signature, closed_mesh}, Case{"SignatureOpen", signature, open_mesh}),
    [](const auto& i) { return std::string(i.param.name); });

TEST_P(FeatureOrder, ChangesNoBitWithAnyNumberOfThreads)
{
  const TriangleMesh mesh = GetParam().mesh();
  for (const double style : {traced, segments}) {
    if (style == segments && GetParam().filter != directions) continue;
    const FilterResult reference = result_of(GetParam().filter(), mesh, 1, style);
    for (const int threads : {1, 2, 3}) {
      const ShuffledMesh other = test_support::shuffled(mesh, std::uint32_t(threads));
      expect_same_bits(reference, result_of(GetParam().filter(), other.mesh, threads, style), other);
    }
  }
}

TEST_P(FeatureOrder, ATriangleSoupHasWhatTheWeldedMeshHas)
{
  const TriangleMesh mesh = GetParam().mesh();
  const test_support::Soup other = test_support::soup(mesh);
  const FilterResult welded = result_of(GetParam().filter(), mesh, 1, traced);
  const FilterResult apart = result_of(GetParam().filter(), other.mesh, 1, traced);
  ASSERT_EQ(apart.lines.has_value(), welded.lines.has_value());
  if (welded.lines) {
    EXPECT_FALSE(welded.lines->edges.empty());
    EXPECT_TRUE(apart.lines->positions == welded.lines->positions);
    EXPECT_EQ(apart.lines->edges, welded.lines->edges);
    EXPECT_EQ(apart.lines->quality, welded.lines->quality);
  }
  if (!welded.selection.empty()) { EXPECT_EQ(apart.selection, other.copies(welded.selection)); }
  if (!welded.quality.empty()) { EXPECT_EQ(apart.quality, other.copies(welded.quality)); }
}

}  // namespace
}  // namespace integral_invariant::filter
