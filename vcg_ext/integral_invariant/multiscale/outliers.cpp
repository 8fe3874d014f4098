// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 0: outliers. In: surface. Out: vertices that stand out, and where they would be. Cost: see the header.
// Source: docs/method.md.
#include "integral_invariant/multiscale/outliers.h"

#include <algorithm>
#include <cmath>

#include "integral_invariant/jets/height_polynomial.h"
#include "integral_invariant/jets/jet_fit.h"

namespace integral_invariant {

namespace {

constexpr std::uint32_t none = ~std::uint32_t(0);

/// Looks at one vertex after the other; holds scratch memory, so one a thread.
class OutlierTest {
 public:
  OutlierTest(const Surface& surface, const std::vector<Vec3>& normals) : surface_(surface), normals_(normals) {}

  /// Whether v stands out of its neighbours by more than its share of their edges.
  bool is_candidate(std::uint32_t v) const
  {
    constexpr double least_share = 0.25;
    constexpr std::uint32_t least_neighbours = 3;
    const std::uint32_t count = valence(v);
    if (count < least_neighbours || count > most_neighbours) return false;
    double edges = 0;
    for (std::uint32_t i = 0; i < count; ++i) edges += norm(position(neighbour(v, i)) - position(v));
    return std::abs(rise(v, none)) > least_share * edges / count;
  }

  bool is_outlier(std::uint32_t v, Vec3& place)
  {
    constexpr double largest_rise = 4.5, largest_deviation = 6;
    constexpr std::size_t most_others = 1;  // a crease has at least two within two rings, a corner more
    gather(v);
    constexpr std::size_t least_around = 10, most_around = 400;
    if (around_.size() < least_around || around_.size() > most_around) return false;
    const double own = std::abs(rise(v, none));
    rises_.clear();
    for (const std::uint32_t w : around_) rises_.push_back(std::abs(rise(w, v)));
    const std::size_t all = around_.size();
    keep_calm(own);
    if (all - around_.size() > most_others) return false;
    const auto usual = rises_.begin() + std::ptrdiff_t(rises_.size() * 3 / 4);
    std::nth_element(rises_.begin(), usual, rises_.end());
    if (around_.size() < least_around || own < largest_rise * *usual) return false;

    const HeightFrame frame(normals_[v]);
    const Height height = height_at(v, frame);
    place = position(v) + frame.normal * height.value;
    return std::abs(height.value) > largest_deviation * height.deviation;
  }

 private:
  struct Height {
    double value = 0, deviation = INFINITY;  ///< over v, of a quadric through the vertices around; of these from it
  };

  /// The hub of a fan has nothing to say about its spokes, and their number squared would be the work.
  static constexpr std::uint32_t most_neighbours = 64;

  std::uint32_t valence(std::uint32_t v) const
  {
    return surface_.neighbour_start()[v + 1] - surface_.neighbour_start()[v];
  }
  const Vec3& position(std::uint32_t v) const { return surface_.positions()[v]; }
  std::uint32_t neighbour(std::uint32_t v, std::uint32_t i) const
  {
    return surface_.neighbours()[surface_.neighbour_start()[v] + i];
  }

  /// Of a vertex over the mean of its neighbours, along its normal, `without` one of them.
  double rise(std::uint32_t v, std::uint32_t without) const
  {
    Vec3 sum;
    int count = 0;
    for (std::uint32_t e = surface_.neighbour_start()[v]; e < surface_.neighbour_start()[v + 1]; ++e) {
      if (surface_.neighbours()[e] == without) continue;
      sum += position(surface_.neighbours()[e]);
      ++count;
    }
    return count > 0 ? dot(position(v) - sum * (1.0 / count), normals_[v]) : 0;
  }

  /// The vertices within two rings, without v.
  void gather(std::uint32_t v)
  {
    around_.clear();
    const auto add_neighbours = [&](std::uint32_t u) {
      for (std::uint32_t e = surface_.neighbour_start()[u]; e < surface_.neighbour_start()[u + 1]; ++e)
        if (const std::uint32_t w = surface_.neighbours()[e]; w != v && valence(w) <= most_neighbours)
          around_.push_back(w);
    };
    add_neighbours(v);
    const std::size_t first_ring = around_.size();
    for (std::size_t i = 0; i < first_ring; ++i) add_neighbours(around_[i]);
    std::sort(around_.begin(), around_.end());
    around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
  }

  /// Takes those out of around_ that stand out about as much: another outlier must not hide this one.
  void keep_calm(double own)
  {
    constexpr double largest_share = 0.5;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < around_.size(); ++i)
      if (rises_[i] < largest_share * own) around_[kept++] = around_[i];
    around_.resize(kept);
  }

  Height height_at(std::uint32_t v, const HeightFrame& frame)
  {
    constexpr int degree = 2;
    std::sort(around_.begin(), around_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return squared_norm(position(a) - position(v)) < squared_norm(position(b) - position(v));
    });
    around_.resize(std::min(around_.size(), HeightPlaces::capacity));
    const double unit = norm(position(around_.back()) - position(v));
    places_.resize(around_.size());
    for (std::size_t i = 0; i < around_.size(); ++i) {
      const Vec3 d = position(around_[i]) - position(v);
      places_.set(i, dot(d, frame.x) / unit, dot(d, frame.y) / unit, dot(d, frame.normal), 1);
    }
    places_.complete(degree);
    const HeightFit fit(sums_of(places_, degree), degree);
    const FitQuality quality = fit.degree() == degree ? fit.quality(places_) : FitQuality{};
    if (!(quality.freedom >= 1)) return {};
    return {fit.coefficients()[0], std::sqrt(quality.squares / quality.freedom)};
  }

  const Surface& surface_;
  const std::vector<Vec3>& normals_;
  std::vector<std::uint32_t> around_;
  std::vector<double> rises_;
  HeightPlaces places_;
};

}  // namespace

std::vector<Outlier> find_outliers(const Surface& surface, Execution& execution)
{
  const std::vector<Vec3> normals = patch_normals(surface, execution);
  std::vector<Vec3> place;
  std::vector<char> is_outlier;
  resize_in_steps(place, surface.vertex_count(), execution);
  resize_in_steps(is_outlier, surface.vertex_count(), execution);
  parallel_step(surface.vertex_count(), 2048, execution, [&](std::size_t begin, std::size_t end, int) {
    OutlierTest test(surface, normals);
    for (std::size_t v = begin; v < end; ++v)
      is_outlier[v] = test.is_candidate(std::uint32_t(v)) && test.is_outlier(std::uint32_t(v), place[v]);
  });
  std::vector<Outlier> outliers;
  for_each_in_order(is_outlier.size(), execution, [&](std::size_t v) {
    if (is_outlier[v]) outliers.push_back({std::uint32_t(v), place[v]});
  });
  return outliers;
}

}  // namespace integral_invariant
