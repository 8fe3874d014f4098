// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: correlated noise. In: offset-free tensors of all scales, the noise that polynomials see. Out: correlation
// length, σ of every vertex. Cost: see the header. Source: docs/method.md §7.
#include "integral_invariant/multiscale/correlated_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "integral_invariant/ball_curvature/offset_free.h"
#include "integral_invariant/multiscale/noise_transfer.h"
#include "integral_invariant/multiscale/valid_scales.h"
#include "integral_invariant/support/kernel_sum.h"

namespace integral_invariant {

namespace {

constexpr std::size_t most_bands = 8;  ///< differences of neighbouring scales, the finest first
constexpr std::size_t place_stride = 64;
constexpr std::size_t most_judges = 400;  ///< places that decide on the correlation

/// What one place shows: mean squares of the differences, how many independent ones they come from, and what the
/// polynomials leave over.
struct Place {
  std::array<double, most_bands> energy{}, freedom{};
  double residual = 0;
};

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

/// Fourth moment over the square of the second of the differences of H, each over its neighbourhood's level.
struct Kurtosis {
  double fourth = 0, second = 0, count = 0;
  double value() const { return count > 0 ? fourth * count / (second * second) : 0; }
};

/// Whether the vertices lie on a lattice, as those of a binary mask's surface and of rounded coordinates do: each
/// coordinate takes few values.
bool lies_on_lattice(const std::vector<Vec3>& positions)
{
  constexpr std::size_t most = 20000, vertices_per_value = 8;
  const std::size_t stride = positions.size() / most + 1;
  const std::array<double Vec3::*, 3> axes{&Vec3::x, &Vec3::y, &Vec3::z};
  return std::all_of(axes.begin(), axes.end(), [&](double Vec3::*axis) {
    std::vector<double> values;
    for (std::size_t v = 0; v < positions.size(); v += stride) values.push_back(positions[v].*axis);
    std::sort(values.begin(), values.end());
    const auto distinct = std::unique(values.begin(), values.end()) - values.begin();
    return std::size_t(distinct) * vertices_per_value < values.size();
  });
}

class Spectrum {
 public:
  Spectrum(const Surface& surface, const TensorField& tensors, const NoiseLevel& white, Execution& execution)
      : surface_(surface),
        tensors_(tensors),
        execution_(execution),
        is_on_lattice_(lies_on_lattice(surface.positions()))
  {
    const std::vector<double>& radii = tensors.radii();
    // Larger balls hold few independent places, and shape rules there.
    constexpr double largest_radius = 16;
    while (bands_ < most_bands && bands_ + 1 < radii.size() && radii[bands_ + 1] <= largest_radius) ++bands_;
    places_.resize((tensors.vertex_count() + place_stride - 1) / place_stride);
    // Polynomials follow the steps of a lattice, so that what they leave over bounds nothing.
    for (std::size_t i = 0; i < places_.size(); ++i)
      places_[i].residual = is_on_lattice_ ? std::numeric_limits<double>::infinity()
                                           : white.sigma[vertex_of(i)] * white.sigma[vertex_of(i)];
    for (std::size_t i = 0; i < bands_; ++i) measure(i);
  }

  bool is_on_lattice() const { return is_on_lattice_; }
  std::size_t bands() const { return bands_; }
  const std::vector<Place>& places() const { return places_; }
  double kurtosis(std::size_t band) const { return kurtosis_[band].value(); }

 private:
  std::size_t vertex_of(std::size_t place) const
  {
    return std::min(place * place_stride + place_stride / 2, tensors_.vertex_count() - 1);
  }

  /// What flat triangles of edge ē cost, times r⁴: as estimate_noise_level() has it, but of a ball that noise hardly
  /// moves.
  double triangulation_error(std::size_t v) const
  {
    constexpr double of_curvature = 0.11;
    const int calm = std::min(4, int(tensors_.radii().size()) - 1);
    return of_curvature * std::abs(tensors_.at_scale(v, calm).k.trace()) / 2;
  }

  /// Outliers and creases stand out of the neighbourhood's average of the logarithms; they are cut off.
  void measure(std::size_t band)
  {
    constexpr double least_cell = 8, largest_cell = 25, largest_share = 6, least = 1e-24;
    const double small = tensors_.radii()[band], large = tensors_.radii()[band + 1];
    const std::size_t n = tensors_.vertex_count();
    const KernelSum pool(surface_.positions(), std::clamp(2 * large, least_cell, largest_cell), execution_);
    std::vector<double> squares;
    std::vector<std::array<double, 2>> sums;
    resize_in_steps(squares, n, execution_);
    resize_in_steps(sums, n, execution_);
    for_each_index(n, execution_, [&](std::size_t v) {
      squares[v] = surface_.is_referenced(v)
                       ? squared_difference(tensors_.at_scale(v, int(band)), tensors_.at_scale(v, int(band) + 1), large)
                       : -1;
      sums[v] = {squares[v] >= 0 ? std::log(squares[v] + least) : 0, squares[v] >= 0 ? 1.0 : 0};
    });
    pool.splat_and_slice(sums, execution_);
    for_each_index(n, execution_, [&](std::size_t v) {
      const double usual = sums[v][1] > 0 ? std::exp(sums[v][0] / sums[v][1]) : 0;
      sums[v] = {squares[v] >= 0 ? std::min(squares[v], largest_share * usual) : 0, squares[v] >= 0 ? 1.0 : 0};
    });
    pool.splat_and_slice(sums, execution_);
    add_kurtosis(band, squares, sums);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const std::size_t v = vertex_of(i);
      if (!(sums[v][1] > 0.5)) continue;
      constexpr double usual_area = 0.87, independent_share = 0.7, components = 3;
      const double rim = independent_share * small;
      const double flat = triangulation_error(v) / (small * small * small * small);
      const double energy = sums[v][0] / sums[v][1], of_noise = std::max(0.0, energy - flat * flat);
      places_[i].energy[band] = of_noise + least;
      const double share = of_noise / (energy + least);
      places_[i].freedom[band] = share * share * std::max(1.0, sums[v][1] * usual_area * components / (pi * rim * rim));
    }
  }

  void add_kurtosis(std::size_t band, const std::vector<double>& squares,
                    const std::vector<std::array<double, 2>>& sums)
  {
    constexpr double largest = 12;
    for_each_in_order(squares.size(), execution_, [&](std::size_t v) {
      if (squares[v] < 0 || !(sums[v][0] > 0)) return;
      const double mean =
          (tensors_.at_scale(v, int(band)).k.trace() - tensors_.at_scale(v, int(band) + 1).k.trace()) / 2;
      const double z = std::min(largest, mean * mean * sums[v][1] / sums[v][0]);
      kurtosis_[band].fourth += z * z;
      kurtosis_[band].second += z;
      kurtosis_[band].count += 1;
    });
  }

  const Surface& surface_;
  const TensorField& tensors_;
  Execution& execution_;
  const bool is_on_lattice_;
  std::size_t bands_ = 0;
  std::vector<Place> places_;
  std::array<Kurtosis, most_bands> kurtosis_;
};

constexpr std::array<double, 8> correlations{0, 0.35, 0.5, 0.75, 1, 1.5, 2, 3};
constexpr std::array<double, 5> slopes{2.2, 2.8, 3.6, 5, 7};  ///< of shape from band to band, over that of white noise
constexpr int level_count = 24, amplitude_count = 28;
constexpr double least_level = 0.004, largest_level = 1;

double level(int i) { return least_level * std::pow(largest_level / least_level, double(i) / (level_count - 1)); }

/// Smoothing to a correlation of ℓ edges divides independent noise by 3.7 ℓ (2 ℓ √(π/area)). What would have been more
/// than a good edge before is shape.
bool is_plausible(double sigma, double correlation)
{
  constexpr double per_length = 3.7, largest = 1.3;
  return correlation == 0 || sigma * std::max(1.0, per_length * correlation) < largest;
}

/// Log likelihoods of noise levels at a place, shape at its best, for one correlation length.
class Levels {
 public:
  Levels(double correlation, const std::vector<double>& radii, std::size_t bands)
      : correlation_(correlation), bands_(bands)
  {
    // The polynomials through the nearest vertices follow what is longer than about 2.7 edges.
    constexpr double cut = 2.3;
    residual_share_ = std::exp(-cut * cut * correlation * correlation / 2);
    const std::vector<double> noise = difference_variances(correlation, radii);
    const std::vector<double> white = difference_variances(0, radii);
    for (int i = -1; i < level_count; ++i) {
      const double square = i < 0 ? 0 : level(i) * level(i);
      for (const double slope : slopes)
        for (int a = -1; a < amplitude_count; ++a) add_model(square, noise, white, slope, a);
    }
  }

  /// Of every level, that of no noise first.
  std::array<double, level_count + 1> log_likelihoods(const Place& place) const
  {
    std::array<double, level_count + 1> best;
    const std::size_t each = slopes.size() * (amplitude_count + 1);
    for (std::size_t l = 0; l < best.size(); ++l) {
      double largest = -std::numeric_limits<double>::infinity();
      for (std::size_t m = l * each; m < (l + 1) * each; ++m) {
        double sum = 0;
        for (std::size_t i = 0; i < bands_; ++i)
          sum += place.freedom[i] * (log_[m * bands_ + i] + place.energy[i] * inverse_[m * bands_ + i]);
        largest = std::max(largest, -sum / 2);
      }
      best[l] = largest + of_residual(place, l == 0 ? 0 : level(int(l) - 1));
      if (l > 0 && !is_plausible(level(int(l) - 1), correlation_)) best[l] = -1e30;
    }
    return best;
  }

 private:
  void add_model(double square, const std::vector<double>& noise, const std::vector<double>& white, double slope, int a)
  {
    constexpr double least = 1e-14, smallest = 3e-6, step = 2.2;  // of the shape's amplitude in the finest band, as σ
    const double amplitude = a < 0 ? 0 : smallest * std::pow(step, a / 2.0);
    for (std::size_t i = 0; i < bands_; ++i) {
      const double shape = amplitude * amplitude * white[i] * std::pow(slope, 2.0 * double(i));
      const double mean = square * noise[i] + shape + least;
      log_.push_back(std::log(mean));
      inverse_.push_back(1 / mean);
    }
  }

  /// Shape may add to what the polynomials leave over, so that it bounds noise from above only.
  double of_residual(const Place& place, double sigma) const
  {
    constexpr double tolerance = 16;  // the share is known for a Gaussian correlation only
    const double expected = residual_share_ * sigma * sigma, found = tolerance * place.residual;
    if (expected <= found) return 0;
    return -place.freedom[0] / 2 * (std::log(expected / std::max(found, 1e-24)) + found / expected - 1);
  }

  double correlation_;
  std::size_t bands_;
  double residual_share_ = 1;
  std::vector<double> log_, inverse_;  ///< models × bands
};

/// Of the logarithm of σ from place to place.
constexpr double level_spread = 0.7;

double penalty(std::size_t l, double centre)
{
  if (l == 0) return 0;
  const double deviation = (std::log(level(int(l) - 1)) - centre) / level_spread;
  return deviation * deviation / 2;
}

struct Fit {
  double score = -std::numeric_limits<double>::infinity();
  double centre = 0;  ///< logarithm of the usual level
  double gain = 0;    ///< of log likelihood over no noise, a place
};

/// The usual level that explains most, each place having its own about it.
Fit best_fit(const Levels& levels, const std::vector<const Place*>& judges)
{
  std::vector<std::array<double, level_count + 1>> each;
  for (const Place* place : judges) each.push_back(levels.log_likelihoods(*place));
  Fit best;
  double none = 0;
  for (const auto& likelihoods : each) none += likelihoods[0];
  best.score = none;
  for (int c = 0; c < level_count; ++c) {
    const double centre = std::log(level(c));
    double sum = 0;
    for (const auto& likelihoods : each) {
      double largest = -std::numeric_limits<double>::infinity();
      for (std::size_t l = 1; l <= level_count; ++l) largest = std::max(largest, likelihoods[l] - penalty(l, centre));
      sum += largest;
    }
    if (sum > best.score) best = {sum, centre, (sum - none) / double(each.size())};
  }
  return best;
}

/// Noise is Gaussian: kurtosis 3. The bands between the triangles and the features speak.
bool is_gaussian(const Spectrum& spectrum)
{
  constexpr double least = 2.4, largest = 3.6;
  constexpr std::size_t first = 2, last = 3;
  for (std::size_t band = first; band <= last; ++band)
    if (!(spectrum.kurtosis(band) > least && spectrum.kurtosis(band) < largest)) return false;
  return true;
}

}  // namespace

CorrelatedNoise find_correlated_noise(const Surface& surface, const TensorField& tensors, const NoiseLevel& white,
                                      Execution& execution)
{
  const std::size_t n = surface.vertex_count();
  CorrelatedNoise result;
  resize_in_steps(result.sigma, n, execution);
  const Spectrum spectrum(surface, tensors, white, execution);
  // Steps of a lattice are noise, whatever their distribution.
  if (spectrum.bands() < 3 || !(spectrum.is_on_lattice() || is_gaussian(spectrum))) return result;

  std::vector<const Place*> judges;
  const std::size_t stride = std::max<std::size_t>(1, spectrum.places().size() / most_judges);
  for (std::size_t i = 0; i < spectrum.places().size(); i += stride)
    if (spectrum.places()[i].freedom[0] > 0) judges.push_back(&spectrum.places()[i]);
  std::array<Fit, correlations.size()> fits;
  parallel_step(fits.size(), 1, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i)
      fits[i] = best_fit(Levels(correlations[i], tensors.radii(), spectrum.bands()), judges);
  });
  std::size_t best = 0;
  for (std::size_t i = 1; i < fits.size(); ++i)
    if (fits[i].score > fits[best].score) best = i;
  // Small gains are shape that the family of shapes does not quite have: clean meshes show up to 0.8, noise 1.5
  // to 90.
  constexpr double least_gain = 1.5;
  if (fits[best].gain < least_gain) return result;

  result.correlation = correlations[best];
  const Levels levels(result.correlation, tensors.radii(), spectrum.bands());
  std::vector<std::array<double, 2>> sums;
  resize_in_steps(sums, n, execution);
  parallel_step(spectrum.places().size(), 8, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) {
      const Place& place = spectrum.places()[i];
      const auto likelihoods = levels.log_likelihoods(place);
      std::size_t l = 1;
      for (std::size_t k = 1; k <= level_count; ++k)
        if (likelihoods[k] - penalty(k, fits[best].centre) > likelihoods[l] - penalty(l, fits[best].centre)) l = k;
      const double sigma = level(int(l) - 1), counts = place.freedom[0] > 0;
      for (std::size_t v = i * place_stride; v < std::min(n, (i + 1) * place_stride); ++v)
        sums[v] = {counts * sigma * sigma, counts};
    }
  });
  constexpr double cell = 16;
  KernelSum(surface.positions(), cell, execution).splat_and_slice(sums, execution);
  const double usual = std::exp(fits[best].centre);
  for_each_index(n, execution, [&](std::size_t v) {
    result.sigma[v] = sums[v][1] > 1e-3 ? std::sqrt(sums[v][0] / sums[v][1]) : usual;
  });
  return result;
}

void add_correlated_noise(const CorrelatedNoise& correlated, NoiseLevel& noise, Execution& execution)
{
  constexpr double inflation = 1.7;  // of the variance
  noise.transfer = NoiseTransfer(correlated.correlation);
  double sum = 0;
  for_each_in_order(noise.sigma.size(), execution, [&](std::size_t v) {
    const double white = noise.sigma[v] * noise.sigma[v], found = correlated.sigma[v] * correlated.sigma[v];
    if (found > white) {
      const double variance = white + inflation * (found - white);
      noise.density[v] *= white > 0 ? variance / white : 1;
      if (!(white > 0)) noise.density[v] = 0.87 * variance;
      noise.sigma[v] = std::sqrt(variance);
      noise.lack_of_fit[v] = 0;
    }
    sum += noise.sigma[v] * noise.sigma[v];
  });
  noise.mean_sigma = std::sqrt(sum / double(std::max<std::size_t>(1, noise.sigma.size())));
}

}  // namespace integral_invariant
