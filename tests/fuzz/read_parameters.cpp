// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/read_parameters.h"

#include <algorithm>

namespace fuzz {

namespace {

using integral_invariant::Parameters;

constexpr std::size_t memory_limit_mb = 8;
constexpr int most_iterations = 300, most_passes = 20, most_scales = 9, most_threads = 3;
constexpr double most_cells = 6;
/// Grids are slow under sanitizers, where the smallest radii need one for each vertex.
constexpr int most_scales_on_grids = 4;
constexpr double most_cells_on_grids = 3;

enum class Source { by_default, in_range, anything };

Source read_source(ByteReader& bytes)
{
  const std::uint32_t choice = bytes.below(32);
  return choice < 16 ? Source::by_default : choice < 31 ? Source::in_range : Source::anything;
}

void read_real(ByteReader& bytes, double low, double high, double& value)
{
  const Source source = read_source(bytes);
  if (source == Source::in_range) value = bytes.between(low, high);
  if (source == Source::anything) value = bytes.any_real();
}

/// A length of any size.
void read_length(ByteReader& bytes, double& value)
{
  const Source source = read_source(bytes);
  if (source == Source::in_range) value = bytes.flag() ? bytes.between(0, 4) : bytes.magnitude();
  if (source == Source::anything) value = bytes.any_real();
}

template <class Whole>
void read_whole(ByteReader& bytes, int low, int high, Whole& value)
{
  const Source source = read_source(bytes);
  if (source == Source::in_range) value = Whole(low + int(bytes.below(std::uint32_t(high - low + 1))));
  if (source == Source::anything) value = Whole(bytes.any_int());
}

/// Beyond `largest` only what is refused.
void bound(int& value, int largest, int limit)
{
  if (value > largest && value <= limit) value = largest;
}

}  // namespace

Parameters read_parameters(ByteReader& bytes)
{
  Parameters p;
  if (bytes.below(3) == 0) p = integral_invariant::published_method();
  read_whole(bytes, 0, 2, p.radius_choice);
  read_whole(bytes, 0, 2, p.estimator);
  read_length(bytes, p.noise);
  read_whole(bytes, 0, 1, p.engine);
  read_whole(bytes, 1, most_scales, p.scales);
  read_whole(bytes, 0, 1, p.spacing);
  read_length(bytes, p.r_min);
  read_length(bytes, p.r_max);
  read_length(bytes, p.radius);
  read_real(bytes, 0, 10, p.alpha);
  read_real(bytes, 0, 1, p.step);
  read_whole(bytes, 0, 1, p.start_radius);
  read_whole(bytes, 0, most_iterations, p.max_iterations);
  read_real(bytes, 0, 0.5, p.tolerance);
  p.smooth_radius = bytes.flag();
  read_whole(bytes, 0, most_passes, p.smoothing_passes);
  read_real(bytes, 1, most_cells, p.fft_cells_per_radius);
  read_whole(bytes, 0, 2, p.exactness);
  p.same_sheet = bytes.flag();
  read_whole(bytes, 1, most_threads, p.threads);
  keep_small(p);
  return p;
}

void keep_small(Parameters& p)
{
  using namespace integral_invariant::limits;
  p.memory_limit_mb = memory_limit_mb;
  bound(p.scales, most_scales, max_scales);
  bound(p.max_iterations, most_iterations, max_iterations);
  bound(p.smoothing_passes, most_passes, max_smoothing_passes);
  if (p.fft_cells_per_radius > most_cells && p.fft_cells_per_radius <= max_cells_per_radius)
    p.fft_cells_per_radius = most_cells;
  if (p.engine != integral_invariant::EngineKind::volume_fft) return;
  bound(p.scales, most_scales_on_grids, max_scales);
  p.fft_cells_per_radius = std::min(p.fft_cells_per_radius, most_cells_on_grids);
}

}  // namespace fuzz
