// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: correlated noise. In: offset-free tensors of all scales. Out: correlation length, σ of every vertex.
// Cost: see the header. Source: docs/method.md.
#include "integral_invariant/multiscale/correlated_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "integral_invariant/multiscale/noise_transfer.h"
#include "integral_invariant/multiscale/scale_spectrum.h"
#include "integral_invariant/support/kernel_sum.h"

namespace integral_invariant {

namespace {

using Place = ScaleSpectrum::Place;

constexpr std::size_t most_judges = 400;  ///< places that decide on the correlation
constexpr std::array<double, 8> correlations{0, 0.35, 0.5, 0.75, 1, 1.5, 2, 3};
/// Of the radius, by which shape rises over independent noise: differences of a wave that is long against the balls go
/// with r², of noise with r⁻³.
constexpr std::array<double, 2> shape_exponents{4, 5};
constexpr std::size_t level_count = 24;
constexpr int amplitude_count = 28;
constexpr double least_level = 0.004, largest_level = 0.7;

/// Standard deviations that are tried; none for 0.
double level(std::size_t i)
{
  return i == 0 ? 0 : least_level * std::pow(largest_level / least_level, double(i - 1) / (level_count - 1));
}

using Likelihoods = std::array<double, level_count + 1>;

/// Log likelihoods of noise levels at a place, shape at its best, for one correlation length.
class Levels {
 public:
  Levels(double correlation, const std::vector<double>& radii, std::size_t bands) : bands_(bands)
  {
    const std::vector<double> noise = difference_variances(correlation, radii);
    const std::vector<double> white = difference_variances(0, radii);
    for (std::size_t l = 0; l <= level_count; ++l)
      for (const double exponent : shape_exponents)
        for (int a = -1; a < amplitude_count; ++a)
          add_model(level(l) * level(l), noise, rising_shape(white, radii, exponent), a);
  }

  Likelihoods of(const Place& place) const
  {
    Likelihoods best;
    const std::size_t each = shape_exponents.size() * (amplitude_count + 1);
    for (std::size_t l = 0; l < best.size(); ++l) {
      best[l] = -std::numeric_limits<double>::infinity();
      for (std::size_t m = l * each; m < (l + 1) * each; ++m) {
        double sum = 0;
        for (std::size_t i = 0; i < bands_; ++i)
          sum += place.freedom[i] * (log_[m * bands_ + i] + place.energy[i] * inverse_[m * bands_ + i]);
        best[l] = std::max(best[l], -sum / 2);
      }
    }
    return best;
  }

 private:
  static std::vector<double> rising_shape(std::vector<double> white, const std::vector<double>& radii, double exponent)
  {
    for (std::size_t i = 0; i < white.size(); ++i) white[i] *= std::pow(radii[i] / radii[0], 2 * exponent);
    return white;
  }

  void add_model(double square, const std::vector<double>& noise, const std::vector<double>& shape, int a)
  {
    constexpr double least = 1e-14, smallest = 3e-6, step = 2.2;  // of the shape's amplitude in the finest band, as σ
    const double amplitude = a < 0 ? 0 : smallest * std::pow(step, a / 2.0);
    for (std::size_t i = 0; i < bands_; ++i) {
      const double mean = square * noise[i] + amplitude * amplitude * shape[i] + least;
      log_.push_back(std::log(mean));
      inverse_.push_back(1 / mean);
    }
  }

  std::size_t bands_;
  std::vector<double> log_, inverse_;  ///< models × bands
};

/// Against the logarithm of the usual level: noise differs little from place to place.
double penalty(std::size_t l, double centre)
{
  constexpr double level_spread = 0.7;
  if (l == 0) return 0;
  const double deviation = (std::log(level(l)) - centre) / level_spread;
  return deviation * deviation / 2;
}

/// The level that explains a place best beside a usual one.
std::size_t best_level(const Likelihoods& likelihoods, double centre)
{
  std::size_t best = 1;
  for (std::size_t l = 2; l <= level_count; ++l)
    if (likelihoods[l] - penalty(l, centre) > likelihoods[best] - penalty(best, centre)) best = l;
  return best;
}

/// What one correlation length explains.
struct Fit {
  double correlation = 0;
  double score = -std::numeric_limits<double>::infinity();
  double centre = 0;  ///< logarithm of the usual level
  double gain = 0;    ///< of log likelihood over no noise, a place
};

/// The usual level that explains most, each place having its own about it.
Fit best_fit(double correlation, const ScaleSpectrum& spectrum, const std::vector<double>& radii,
             const std::vector<const Place*>& judges)
{
  const Levels levels(correlation, radii, spectrum.bands());
  std::vector<Likelihoods> each;
  for (const Place* place : judges) each.push_back(levels.of(*place));
  Fit best{correlation};
  double none = 0;
  for (const Likelihoods& likelihoods : each) none += likelihoods[0];
  best.score = none;
  for (std::size_t c = 1; c <= level_count; ++c) {
    const double centre = std::log(level(c));
    double sum = 0;
    for (const Likelihoods& likelihoods : each) {
      const std::size_t l = best_level(likelihoods, centre);
      sum += likelihoods[l] - penalty(l, centre);
    }
    if (sum > best.score) best = {correlation, sum, centre, (sum - none) / double(each.size())};
  }
  return best;
}

Fit best_fit(const ScaleSpectrum& spectrum, const std::vector<double>& radii, const std::vector<const Place*>& judges,
             Execution& execution)
{
  std::array<Fit, correlations.size()> fits;
  parallel_step(fits.size(), 1, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) fits[i] = best_fit(correlations[i], spectrum, radii, judges);
  });
  return *std::max_element(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.score < b.score; });
}

std::vector<const Place*> judges_of(const ScaleSpectrum& spectrum)
{
  std::vector<const Place*> judges;
  const std::size_t stride = std::max<std::size_t>(1, spectrum.places().size() / most_judges);
  for (std::size_t i = 0; i < spectrum.places().size(); i += stride)
    if (spectrum.places()[i].freedom[0] > 0) judges.push_back(&spectrum.places()[i]);
  return judges;
}

/// Kurtosis of Gaussian noise is 3, and a little less over the level of a close neighbourhood, which has few
/// independent values. The bands speak that the fit takes for noise; not the finest, which sees the triangles' shapes.
/// Measured: noise 2.62 to 3.2 close by and 2.8 to 3.5 over a wide neighbourhood, even bumps at most 2.54 close by, 40
/// clean models 3.14 and more and 3.66 and more.
bool is_gaussian(const ScaleSpectrum& spectrum, const Fit& fit, const std::vector<double>& radii,
                 const std::vector<const Place*>& judges)
{
  constexpr double least = 2.57, largest = 3.3, largest_wide = 3.6;
  const double square = std::exp(2 * fit.centre);
  const std::vector<double> noise = difference_variances(fit.correlation, radii);
  double close = 0, wide = 0, weights = 0;
  for (std::size_t band = 1; band < spectrum.bands(); ++band) {
    double share = 0;
    for (const Place* place : judges) share += std::min(1.0, square * noise[band] / place->energy[band]);
    const double weight = share * share;
    close += weight * spectrum.close_kurtosis(band);
    wide += weight * spectrum.wide_kurtosis(band);
    weights += weight;
  }
  return close > least * weights && close < largest * weights && wide < largest_wide * weights;
}

/// σ² at every vertex: of the places around, each at its best level.
void spread_levels(const Surface& surface, const ScaleSpectrum& spectrum, const std::vector<double>& radii,
                   const Fit& fit, std::vector<double>& sigma, Execution& execution)
{
  constexpr double cell = 16;
  constexpr std::size_t stride = ScaleSpectrum::place_stride;
  const Levels levels(fit.correlation, radii, spectrum.bands());
  std::vector<std::array<double, 2>> sums;
  resize_in_steps(sums, sigma.size(), execution);
  parallel_step(spectrum.places().size(), 8, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) {
      const Place& place = spectrum.places()[i];
      const double own = level(best_level(levels.of(place), fit.centre)), counts = place.freedom[0] > 0;
      for (std::size_t v = i * stride; v < std::min(sigma.size(), (i + 1) * stride); ++v)
        sums[v] = {counts * own * own, counts};
    }
  });
  KernelSum(surface.positions(), cell, execution).splat_and_slice(sums, execution);
  constexpr double least_count = 1e-3;
  for_each_index(sigma.size(), execution, [&](std::size_t v) {
    sigma[v] = sums[v][1] > least_count ? std::sqrt(sums[v][0] / sums[v][1]) : std::exp(fit.centre);
  });
}

}  // namespace

CorrelatedNoise find_correlated_noise(const Surface& surface, const CoordinateLattice& lattice,
                                      const TensorField& tensors, Execution& execution)
{
  CorrelatedNoise result;
  resize_in_steps(result.sigma, surface.vertex_count(), execution);
  const ScaleSpectrum spectrum(surface, tensors, execution);
  const std::vector<const Place*> judges = judges_of(spectrum);
  constexpr std::size_t least_bands = 3;
  if (spectrum.bands() < least_bands || judges.empty()) return result;

  const Fit fit = best_fit(spectrum, tensors.radii(), judges, execution);
  // Small gains are shape that the family of shapes does not quite have: even bumps show up to 15, noise 20 and more.
  constexpr double least_gain = 16, least_gain_on_lattice = 4;
  // What takes the largest level is larger, and shape.
  const bool is_bounded = fit.centre < std::log(largest_level);
  bool is_noise =
      fit.gain > least_gain && fit.correlation > 0 && is_bounded && is_gaussian(spectrum, fit, tensors.radii(), judges);
  if (lattice.is_from_grid || lattice.is_rounded()) is_noise = fit.gain > least_gain_on_lattice;
  result.is_of_lattice = lattice.is_from_grid || (is_noise && lattice.is_rounded());
  if (is_noise) {
    result.correlation = fit.correlation;
    spread_levels(surface, spectrum, tensors.radii(), fit, result.sigma, execution);
  }
  if (is_noise && lattice.is_rounded()) {
    const int calm = std::min(4, int(tensors.radii().size()) - 1);
    for_each_index(result.sigma.size(), execution, [&](std::size_t v) {
      const double variance = lattice.variance_along(tensors.at_scale(v, calm).normal);
      result.sigma[v] = std::sqrt(std::max(result.sigma[v] * result.sigma[v], variance));
    });
  }
  return result;
}

void add_correlated_noise(const CorrelatedNoise& correlated, NoiseLevel& noise, Execution& execution)
{
  constexpr double inflation = 1.7;  // of the variance
  noise.transfer = NoiseTransfer(correlated.correlation);
  double sum = 0;
  for_each_in_order(noise.sigma.size(), execution, [&](std::size_t v) {
    const double white = noise.sigma[v] * noise.sigma[v], found = correlated.sigma[v] * correlated.sigma[v];
    noise.defies_jets[v] = correlated.is_of_lattice || found > white;
    if (found > white) {
      const double variance = white + inflation * (found - white);
      noise.density[v] += usual_area * (variance - white);
      noise.sigma[v] = std::sqrt(variance);
      noise.lack_of_fit[v] = 0;
    }
    sum += noise.sigma[v] * noise.sigma[v];
  });
  noise.mean_sigma = std::sqrt(sum / double(std::max<std::size_t>(1, noise.sigma.size())));
}

}  // namespace integral_invariant
