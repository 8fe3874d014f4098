// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: scale spectrum. In: offset-free tensors of all scales. Out: energies and kurtosis of their differences.
// Cost: see the header. Source: docs/method.md.
#include "integral_invariant/multiscale/scale_spectrum.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/multiscale/noise_level.h"
#include "integral_invariant/multiscale/valid_scales.h"
#include "integral_invariant/support/kernel_sum.h"
#include "integral_invariant/support/pi.h"

namespace integral_invariant {

namespace {

constexpr double least_energy = 1e-24;  ///< logarithms stay finite

/// Mean square of the three components of the tensors' difference (H and √2 times either of the deviator's have the
/// same variance under noise); below 0 where a ball does not see one sheet alone.
double squared_difference(const CurvatureTensor& small, const CurvatureTensor& large, double large_radius)
{
  constexpr double largest_kr = 1.3;
  const bool is_whole = small.confidence >= least_confidence && large.confidence >= least_confidence &&
                        largest_absolute_curvature(large) * large_radius < largest_kr;
  if (!is_whole) return -1;
  const double mean = (small.k.trace() - large.k.trace()) / 2;
  const Symmetric3 d = small.k - large.k;
  const double squares = d.xx * d.xx + d.yy * d.yy + d.zz * d.zz + 2 * (d.xy * d.xy + d.xz * d.xz + d.yz * d.yz);
  return (squares - mean * mean) / 3;
}

}  // namespace

ScaleSpectrum::ScaleSpectrum(const Surface& surface, const TensorField& tensors, Execution& execution)
    : surface_(surface), tensors_(tensors), execution_(execution)
{
  const std::vector<double>& radii = tensors.radii();
  // Larger balls hold few independent places, and shape rules there.
  constexpr double largest_radius = 16;
  while (bands_ < most_bands && bands_ + 1 < radii.size() && radii[bands_ + 1] <= largest_radius) ++bands_;
  places_.resize((tensors.vertex_count() + place_stride - 1) / place_stride);
  std::vector<double> squares;
  Sums sums;
  resize_in_steps(squares, tensors.vertex_count(), execution);
  resize_in_steps(sums, tensors.vertex_count(), execution);
  for (std::size_t band = 0; band < bands_; ++band) measure(band, squares, sums);
}

std::size_t ScaleSpectrum::vertex_of(std::size_t place) const
{
  return std::min(place * place_stride + place_stride / 2, tensors_.vertex_count() - 1);
}

/// What flat triangles of edge ē cost, times r⁴; of a ball that noise hardly moves.
double ScaleSpectrum::triangulation_error(std::size_t v) const
{
  const int calm = std::min(4, int(tensors_.radii().size()) - 1);
  return flatness_error * std::abs(tensors_.at_scale(v, calm).k.trace()) / 2;
}

void ScaleSpectrum::measure(std::size_t band, std::vector<double>& squares, Sums& sums)
{
  constexpr double least_cell = 8, widest_cell = 25;
  const double large = tensors_.radii()[band + 1];
  for_each_index(squares.size(), execution_, [&](std::size_t v) {
    squares[v] = surface_.is_referenced(v)
                     ? squared_difference(tensors_.at_scale(v, int(band)), tensors_.at_scale(v, int(band) + 1), large)
                     : -1;
  });
  const double cell = std::clamp(2 * large, least_cell, widest_cell);
  add_energies(band, cell, squares, sums);
  close_[band] = kurtosis_within(cell, squares, sums);
  wide_[band] = kurtosis_within(widest_cell, squares, sums);
}

/// Outliers and creases stand out of the neighbourhood's average of the logarithms; they are cut off.
void ScaleSpectrum::add_energies(std::size_t band, double cell, const std::vector<double>& squares, Sums& sums)
{
  constexpr double largest_share = 6, independent_share = 0.7, components = 3;
  const double small = tensors_.radii()[band], rim = independent_share * small;
  const KernelSum pool(surface_.positions(), cell, execution_);
  for_each_index(squares.size(), execution_, [&](std::size_t v) {
    sums[v] = {squares[v] >= 0 ? std::log(squares[v] + least_energy) : 0, squares[v] >= 0 ? 1.0 : 0};
  });
  pool.splat_and_slice(sums, execution_);
  for_each_index(squares.size(), execution_, [&](std::size_t v) {
    const double usual = sums[v][1] > 0 ? std::exp(sums[v][0] / sums[v][1]) : 0;
    sums[v] = {squares[v] >= 0 ? std::min(squares[v], largest_share * usual) : 0, squares[v] >= 0 ? 1.0 : 0};
  });
  pool.splat_and_slice(sums, execution_);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const std::size_t v = vertex_of(i);
    constexpr double least_count = 0.5;
    if (!(sums[v][1] > least_count)) continue;
    const double flat = triangulation_error(v) / (small * small * small * small);
    const double energy = sums[v][0] / sums[v][1], of_noise = std::max(0.0, energy - flat * flat);
    places_[i].energy[band] = of_noise + least_energy;
    const double share = of_noise / (energy + least_energy);
    places_[i].freedom[band] = share * share * std::max(1.0, sums[v][1] * usual_area * components / (pi * rim * rim));
  }
}

Kurtosis ScaleSpectrum::kurtosis_within(double cell, const std::vector<double>& squares, Sums& sums)
{
  constexpr double largest = 12;  // what single vertices can add
  for_each_index(squares.size(), execution_, [&](std::size_t v) {
    sums[v] = {std::max(squares[v], 0.0), squares[v] >= 0 ? 1.0 : 0};
  });
  KernelSum(surface_.positions(), cell, execution_).splat_and_slice(sums, execution_);
  Kurtosis kurtosis;
  for_each_in_order(squares.size(), execution_, [&](std::size_t v) {
    if (squares[v] >= 0 && sums[v][0] > 0) kurtosis.add(std::min(largest, squares[v] * sums[v][1] / sums[v][0]));
  });
  return kurtosis;
}

}  // namespace integral_invariant
