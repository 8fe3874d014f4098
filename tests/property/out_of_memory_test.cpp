// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that runs out at any allocation is survived: std::bad_alloc reaches the caller, and nothing is lost.
#include <gtest/gtest.h>

#include "integral_invariant/curvature.h"
#include "integral_invariant/features/crest_lines.h"
#include "integral_invariant/features/curvature_lines.h"
#include "integral_invariant/features/signature.h"
#include "support/failing_allocation.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

/// Runs `action` with memory that ends at the allocations 1, 2, 4, 8, ..., until it is enough; how often it was not.
template <class Action>
int times_refused(const Action& action)
{
  action();  // what is made once and stays
  const long before = live_blocks();
  int refused = 0;
  for (long n = 1; runs_out_of_memory(n, action); n *= 2) {
    EXPECT_EQ(live_blocks(), before) << "lost at allocation " << n;
    ++refused;
  }
  EXPECT_EQ(live_blocks(), before);
  return refused;
}

struct Case {
  EngineKind engine;
  RadiusChoice choice;
  int threads;
};

class OutOfMemory : public testing::TestWithParam<Case> {
 protected:
  Parameters parameters() const
  {
    Parameters p;
    p.engine = GetParam().engine;
    p.radius_choice = GetParam().choice;
    p.threads = GetParam().threads;
    p.scales = 4;
    return p;
  }
};

constexpr int fewest_refusals = 6;  // every run makes more than 2^6 allocations

}  // namespace

INSTANTIATE_TEST_SUITE_P(Runs, OutOfMemory,
                         testing::Values(Case{EngineKind::surface_integral, RadiusChoice::statistical, 1},
                                         Case{EngineKind::surface_integral, RadiusChoice::statistical, 3},
                                         Case{EngineKind::surface_integral, RadiusChoice::feature_adapted, 3},
                                         Case{EngineKind::volume_fft, RadiusChoice::statistical, 1},
                                         Case{EngineKind::volume_fft, RadiusChoice::feature_adapted, 3}));

TEST_P(OutOfMemory, CurvatureIsRefusedWithoutALoss)
{
  const TriangleMesh mesh = with_normal_noise(torus(2, 0.6, 60, 18), 0.005);
  const Parameters p = parameters();
  EXPECT_GT(times_refused([&] { compute_curvature(mesh, p); }), fewest_refusals);
}

TEST_P(OutOfMemory, SignatureIsRefusedWithoutALoss)
{
  const TriangleMesh mesh = icosphere(3);
  const Parameters p = parameters();
  EXPECT_GT(times_refused([&] { compute_signature(mesh, p); }), fewest_refusals);
}

TEST(OutOfMemoryFeatures, LinesAreRefusedWithoutALoss)
{
  const TriangleMesh mesh = torus(2, 0.6, 60, 18);
  const Result result = compute_curvature(mesh, {});
  const Surface surface(mesh);
  EXPECT_GT(times_refused([&] {
              Execution execution(3);
              CrestLineParameters crest;
              crest.minimum_sharpness = 0;
              find_crest_lines(surface, curvature_field(result), crest, execution);
              trace_curvature_lines(surface, curvature_field(result), {}, execution);
              find_ridges_and_valleys(surface, result, {}, execution);
            }),
            fewest_refusals);
}
