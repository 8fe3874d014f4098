// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 3: scale chain. In: a signal at all scales, what is known about its noise. Out: its value at radius 0, with
// variance.
// Cost: O(n · scales), two averages over the neighbourhood a scale. Source: docs/method.md §9.
#include "integral_invariant/multiscale/scale_filter.h"

#include <algorithm>
#include <cmath>

namespace integral_invariant {

namespace {

using Pair = std::array<double, 2>;

double dot(const Pair& a, const Pair& b) { return a[0] * b[0] + a[1] * b[1]; }

/// Components that are added by the same weights, of one vertex.
struct Strand {
  double variance = 0;           ///< of value's error
  double detail_variance = 0;    ///< of detail's error
  double covariance = 0;         ///< of both errors
  double shape_variance = 1e30;  ///< P of the scale before
  bool is_drowned = false;       ///< a scale showed nothing but noise
};

/// What is known about one vertex on the way from its largest scale down.
struct State {
  Pair value{}, detail{};
  std::array<Strand, 2> strands;
  double log_radius = 0;
};

}  // namespace

class ScaleFilter::Filter {
 public:
  Filter(const FilterContext& evidence, Execution& execution)
      : e_(evidence),
        execution_(execution),
        n_(evidence.least_radius.size()),
        scales_(evidence.radii.size()),
        states_(n_),
        slope_(n_),
        innovation_(n_)
  {
    resize_in_steps(sums_, n_, execution);
  }

  FilteredSignal run(const Signal& signal)
  {
    signal_ = &signal;
    strands_ = gain_group_count(signal.components, signal.evidence);
    of_each_ = signal.components / strands_;
    for (int i = int(scales_) - 1; i >= 0; --i) {
      start_at(i);
      if (i == int(scales_) - 1) continue;
      regress(i);
      update(i);
    }
    return result();
  }

 private:
  /// In units of the noise's variance. What the average over the neighbourhood must pass to be shape, the same after a
  /// scale showed nothing but noise; the most that one vertex can add to the average; what shows at the vertex itself,
  /// and there where less was to be expected.
  static constexpr double least_share = 0.1, drowned_share = 0.3, largest_energy = 25, evident_energy = 12,
                          evident_against_odds = 25;

  bool is_measured(std::size_t v, int i) const { return e_.balls.source[v * scales_ + std::size_t(i)] != Source::none; }
  Pair difference(std::size_t v, int i) const
  {
    const auto &a = signal_->values[v * scales_ + std::size_t(i)],
               &b = signal_->values[v * scales_ + std::size_t(i) + 1];
    return {double(a[0]) - double(b[0]), double(a[1]) - double(b[1])};
  }
  double noise_of(std::size_t v, int i) const { return double(signal_->noise[v * scales_ + std::size_t(i)]); }
  /// Of the difference between scale i and the next; a little of it at least, where one of them is a fit of its own
  /// kind. The larger one may have more of it: a disc that ends at a crease, beside a ball that does not reach it yet.
  double noise_between(std::size_t v, int i) const
  {
    constexpr double least = 0.05;
    return std::max(std::abs(noise_of(v, i) - noise_of(v, i + 1)), least * noise_of(v, i)) + 1e-30;
  }
  /// Mean square of a strand's innovations.
  double energy(std::size_t v, int strand) const
  {
    double sum = 0;
    for (int c = strand * of_each_; c < (strand + 1) * of_each_; ++c) sum += innovation_[v][c] * innovation_[v][c];
    return sum / of_each_;
  }
  /// r_{i+1}² − r_i²
  double gap(int i) const
  {
    const double a = e_.radii[std::size_t(i)], b = e_.radii[std::size_t(i) + 1];
    return b * b - a * a;
  }

  void start_at(int i)
  {
    const double log_radius = std::log(e_.radii[std::size_t(i)]);
    for_each_index(n_, execution_, [&](std::size_t v) {
      if (e_.balls.largest[v] != i) return;
      const auto& y = signal_->values[v * scales_ + std::size_t(i)];
      State state;
      state.value = {double(y[0]), double(y[1])};
      for (Strand& strand : state.strands) strand.variance = noise_of(v, i);
      state.log_radius = log_radius;
      states_[v] = state;
    });
  }

  /// β of step i: the noise of a difference is independent of all that came before, so the regression has no bias.
  /// Where details do not stand out of the noise, which vertices less than a radius apart share, it stays with r².
  void regress(int i)
  {
    constexpr double doubt_share = 0.1;
    for_each_index(n_, execution_, [&](std::size_t v) { slope_[v] = 0; });
    if (!e_.predict || i + 2 >= int(scales_)) return;
    for_each_index(n_, execution_, [&](std::size_t v) {
      sums_[v] = {};
      if (i + 1 >= e_.balls.largest[v] || !is_measured(v, i)) return;
      const double square = dot(states_[v].detail, states_[v].detail);
      sums_[v] = {dot(difference(v, i), states_[v].detail), square, square * square, 1};
    });
    e_.pools[std::size_t(i)].splat_and_slice(sums_, execution_);
    const double square_law = gap(i) / gap(i + 1), sharing = e_.radii[std::size_t(i)] * e_.radii[std::size_t(i)];
    for_each_index(n_, execution_, [&](std::size_t v) {
      const auto& [product, square, fourth_power, count] = sums_[v];
      const double noise = signal_->components * noise_between(v, i), doubt = doubt_share * sharing * noise;
      if (square + doubt > 0)
        slope_[v] = std::clamp((product + doubt * square_law) / (square + doubt), 0.0,
                               square_law * steepness(square, fourth_power, count, noise));
    });
  }

  /// How much more than r² the differences of a neighbourhood may carry on: balls as large as the bumps no longer see
  /// them, and their differences flatten out. But at a crease few differences are much larger than the others, which
  /// would take them for theirs; and where they are far over the noise, the smaller scale speaks for itself.
  static double steepness(double square, double fourth_power, double count, double noise)
  {
    constexpr double largest = 1.5, largest_kurtosis = 3, evident_detail = 25;
    const bool is_even = fourth_power * count <= largest_kurtosis * square * square;
    return is_even && square <= evident_detail * noise * count ? largest : 1;
  }

  void update(int i)
  {
    for_each_index(n_, execution_, [&](std::size_t v) {
      sums_[v] = {};
      innovation_[v] = {};
      if (i >= e_.balls.largest[v] || !is_measured(v, i)) return;
      const Pair d = difference(v, i);
      for (int c = 0; c < 2; ++c) innovation_[v][c] = d[c] - slope_[v] * states_[v].detail[c];
      const double noise = noise_between(v, i);
      // By the noise: noisy members tell less. A crease must not spread its strength over the flat parts around.
      sums_[v] = {1 / noise, 1, 0, 0};
      for (int k = 0; k < strands_; ++k) sums_[v][2 + k] = std::min(energy(v, k) / noise, largest_energy);
    });
    e_.pools[std::size_t(i)].splat_and_slice(sums_, execution_);
    const double log_step = std::log(e_.radii[std::size_t(i) + 1] / e_.radii[std::size_t(i)]);
    for_each_index(n_, execution_, [&](std::size_t v) {
      if (i >= e_.balls.largest[v]) return;
      for (int k = 0; k < strands_; ++k) {
        const double mean = sums_[v][0] > 0 ? std::max(0.0, (sums_[v][2 + k] - sums_[v][1]) / sums_[v][0]) : 0;
        const double weight = update_strand(v, i, k, mean);
        if (k == 0) states_[v].log_radius -= weight * log_step;
      }
    });
  }

  /// `shape`: P by the neighbourhood's average. Returns the weight.
  double update_strand(std::size_t v, int i, int k, double shape)
  {
    Strand& s = states_[v].strands[k];
    const double noise = noise_between(v, i);
    // An average that passes the noise by little is chance, the more so under the scale at which noise took over.
    if (shape < (s.is_drowned ? drowned_share : least_share) * noise) shape = 0;
    s.is_drowned = s.is_drowned || shape == 0;
    // What stands out of the noise at the vertex itself is shape.
    const bool is_fit = e_.balls.source[v * scales_ + std::size_t(i)] == Source::jet;
    const double evident = s.is_drowned || is_fit ? evident_against_odds : evident_energy;
    shape = std::max(shape, energy(v, k) - evident * noise);
    const bool says_nothing = !is_measured(v, i) || e_.radii[std::size_t(i)] < e_.least_radius[v];
    if (says_nothing) shape = 0;
    const double weight = shape / (shape + noise);

    State& state = states_[v];
    for (int c = k * of_each_; c < (k + 1) * of_each_; ++c) {
      state.detail[c] = slope_[v] * state.detail[c] + weight * (says_nothing ? 0 : innovation_[v][c]);
      state.value[c] += state.detail[c];
    }
    add_uncertainty(s, weight, shape, noise, slope_[v]);
    return weight;
  }

  /// Shape under the noise does not show: it is taken to be as large as could have hidden, but to fall with the scale.
  static void add_uncertainty(Strand& s, double weight, double shape, double noise, double slope)
  {
    constexpr double hidden_share = 0.07, largest_decay = 0.5;
    shape = std::max(shape, std::min(hidden_share * noise, largest_decay * s.shape_variance));
    s.shape_variance = shape;
    const double lost = 1 - weight;
    s.detail_variance = lost * lost * shape + weight * weight * noise;
    const double carried = lost * slope * s.covariance;
    s.variance += s.detail_variance + 2 * carried;
    s.covariance = s.detail_variance + carried;
  }

  FilteredSignal result() const
  {
    // K(0) − K(r_0) from K(r_0) − K(r_1), by K = K₀ + c r².
    const double first = e_.radii.front();
    const double beyond = e_.predict && scales_ > 1 ? std::min(1.0, first * first / gap(0)) : 0;
    FilteredSignal result;
    resize_in_steps(result.value, n_, execution_);
    resize_in_steps(result.variance, n_, execution_);
    resize_in_steps(result.radius, n_, execution_);
    for_each_index(n_, execution_, [&](std::size_t v) {
      const State& s = states_[v];
      for (int c = 0; c < 2; ++c) {
        const Strand& strand = s.strands[std::min(c / of_each_, strands_ - 1)];
        result.value[v][c] = s.value[c] + beyond * s.detail[c];
        result.variance[v][c] =
            strand.variance + beyond * beyond * strand.detail_variance + 2 * beyond * strand.covariance;
      }
      result.radius[v] = std::exp(s.log_radius);
    });
    return result;
  }

  const Signal* signal_ = nullptr;
  int strands_ = 0, of_each_ = 0;  ///< and components of each of them
  const FilterContext& e_;
  Execution& execution_;
  const std::size_t n_, scales_;
  ZeroedArray<State> states_;  ///< set at the vertex's largest scale
  ZeroedArray<double> slope_;
  ZeroedArray<Pair> innovation_;
  std::vector<std::array<double, 4>> sums_;  ///< over the neighbourhood
};

ScaleFilter::ScaleFilter(const FilterContext& evidence, Execution& execution)
    : filter_(std::make_unique<Filter>(evidence, execution))
{
}

ScaleFilter::~ScaleFilter() = default;

FilteredSignal ScaleFilter::run(const Signal& signal) { return filter_->run(signal); }

}  // namespace integral_invariant
