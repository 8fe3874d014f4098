// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: the inner loops of polynomial fits. In: places in columns, a system. Out: sums, its factor. Cost: a
// microsecond a fit of degree 4, 2 ns a place of a disc. Source: Cholesky's method.
#include "integral_invariant/jets/least_squares_kernels.h"

#include <cmath>

namespace integral_invariant {

namespace {

constexpr std::size_t lanes = kernel_lanes;

constexpr int groups_of(int count) { return (count + int(lanes) - 1) / int(lanes); }

II_VECTOR_CLONES
void write_monomials(HeightPlaces& places, int degree)
{
  for (std::size_t group = 0; group < places.groups; ++group) {
    for (std::size_t j = 0; j < lanes; ++j) places.monomial[0][group][j] = 1;
    int before = 0, here = 1;
    for (int d = 1; d <= degree; ++d) {
      for (int i = 0; i < d; ++i)
        places.monomial[here + i][group] = places.monomial[before + i][group] * places.x[group];
      places.monomial[here + d][group] = places.monomial[here - 1][group] * places.y[group];
      before = here;
      here += d + 1;
    }
  }
}

}  // namespace

void HeightPlaces::resize(std::size_t count)
{
  groups = (count + lanes - 1) / lanes;
  for (std::size_t p = count; p < groups * lanes; ++p) set(p, 0, 0, 0, 0);
}

void HeightPlaces::complete(int degree) { write_monomials(*this, degree); }

II_VECTOR_CLONES
HeightSums sums_of(const HeightPlaces& places, int degree)
{
  // Σ over the lanes' groups of w m, a degree at a time, from those of the degree before; and of w m h.
  constexpr int degrees = 2 * largest_degree + 1;
  Lanes powers[coefficient_count(2 * largest_degree)], heights[coefficient_count(largest_degree)], squares{};
  for (int k = 0; k < coefficient_count(2 * degree); ++k) powers[k] = Lanes{};
  for (int k = 0; k < coefficient_count(degree); ++k) heights[k] = Lanes{};
  for (std::size_t group = 0; group < places.groups; ++group) {
    const Lanes &x = places.x[group], &y = places.y[group], &h = places.height[group];
    Lanes weighted[degrees];
    weighted[0] = places.weight[group];
    squares += weighted[0] * h * h;
    for (int d = 0, here = 0; d <= 2 * degree; ++d) {
      if (d > 0) {
        weighted[d] = weighted[d - 1] * y;
        for (int i = 0; i < d; ++i) weighted[i] *= x;
      }
      for (int i = 0; i <= d; ++i, ++here) {
        powers[here] += weighted[i];
        if (d <= degree) heights[here] += weighted[i] * h;
      }
    }
  }
  HeightSums sums;
  for (int k = 0; k < coefficient_count(2 * degree); ++k) sums.powers[std::size_t(k)] = sum_of_lanes(powers[k]);
  for (int k = 0; k < coefficient_count(degree); ++k) sums.heights[std::size_t(k)] = sum_of_lanes(heights[k]);
  sums.squares = sum_of_lanes(squares);
  return sums;
}

void PlaceColumns::add(double x, double y, double height)
{
  const std::size_t lane = count % lanes;
  if (count / lanes == groups.size()) groups.emplace_back();
  Group& group = groups[count / lanes];
  if (lane == 0) group = Group{};
  group.x[lane] = x, group.y[lane] = y, group.height[lane] = height;
  ++count;
}

II_VECTOR_CLONES
void add_to_quadric_sums(const PlaceColumns& places, HeightSums& sums)
{
  constexpr std::size_t powers = coefficient_count(4), heights = coefficient_count(2);
  Lanes power[powers] = {}, with_height[heights] = {}, squares{};
  for (std::size_t first = 0; first < places.count; first += lanes) {
    const PlaceColumns::Group& group = places.groups[first / lanes];
    const Lanes &a = group.x, &b = group.y, &h = group.height, aa = a * a, ab = a * b, bb = b * b;
    const Lanes of_place[powers] = {{},     a,      b,       aa,      ab,      bb,      aa * a, aa * b,
                                    a * bb, bb * b, aa * aa, aa * ab, aa * bb, ab * bb, bb * bb};
    for (std::size_t k = 1; k < powers; ++k) power[k] += of_place[k];
    with_height[0] += h;
    for (std::size_t k = 1; k < heights; ++k) with_height[k] += of_place[k] * h;
    squares += h * h;
  }
  sums.powers[0] += double(places.count);
  for (std::size_t k = 1; k < powers; ++k) sums.powers[k] += sum_of_lanes(power[k]);
  for (std::size_t k = 0; k < heights; ++k) sums.heights[k] += sum_of_lanes(with_height[k]);
  sums.squares += sum_of_lanes(squares);
}

HeightMatrix::HeightMatrix(int count)
{
  for (int i = 0; i < count; ++i)
    for (int g = 0; g < groups_of(count); ++g) rows[i][g] = Lanes{};
}

WhitenedColumns::WhitenedColumns(int count)
{
  for (int i = 0; i < count; ++i) rows[i] = Lanes{};
}

namespace {

/// \tparam groups of lanes in a row: the inner loops are as long as that
template <int groups>
II_INLINE int factor_rows(HeightMatrix& a, int count, double least_share)
{
  double least[coefficient_count(largest_degree)];
  for (int i = 0; i < count; ++i) least[i] = least_share * a.at(i, i);
  for (int i = 0; i < count; ++i) {
    if (!(a.at(i, i) > least[i])) return i;
    const double inverse = 1 / std::sqrt(a.at(i, i));
    // Nobody reads what stands left of the diagonal.
    const int first = i / int(lanes);
    Lanes scaled[groups];
    for (int g = first; g < groups; ++g) a.rows[i][g] = scaled[g] = a.rows[i][g] * inverse;
    a.set(i, i, inverse);
    for (int j = i + 1; j < count; ++j)
      for (int g = first; g < groups; ++g) a.rows[j][g] -= scaled[g] * a.at(i, j);
  }
  return count;
}

}  // namespace

II_VECTOR_CLONES
int factor_as_far_as_determined(HeightMatrix& a, int count, double least_share)
{
  switch (groups_of(count)) {
    case 1:
      return factor_rows<1>(a, count, least_share);
    case 2:
      return factor_rows<2>(a, count, least_share);
    case 3:
      return factor_rows<3>(a, count, least_share);
    default:
      return factor_rows<HeightMatrix::most_groups>(a, count, least_share);
  }
}

II_VECTOR_CLONES
void whiten(const HeightMatrix& factor, int count, WhitenedColumns& columns)
{
  for (int i = 0; i < count; ++i) {
    const Lanes done = columns.rows[i] * factor.at(i, i);
    columns.rows[i] = done;
    for (int k = i + 1; k < count; ++k) columns.rows[k] -= done * factor.at(i, k);
  }
}

II_VECTOR_CLONES
FitQuality fit_quality(const HeightPlaces& places, int count, int last, const HeightMatrix& factor,
                       const WhitenedColumns& whitened)
{
  constexpr std::size_t most = coefficient_count(largest_degree), parts = height_part_count;
  Lanes squares{}, freedom{}, top_degree_dof{}, variance[parts] = {};
  for (std::size_t group = 0; group < places.groups; ++group) {
    // z = U⁻ᵀ m, column by column, and its products as the columns are done.
    Lanes z[most], fitted{}, leverage{}, below{}, influence[parts] = {};
    for (int i = 0; i < count; ++i) z[i] = places.monomial[i][group];
    for (int i = 0; i < count; ++i) {
      if (i == last) below = leverage;
      const Lanes done = z[i] * factor.at(i, i), &of = whitened.rows[i];
      fitted += done * of[heights_column];
      leverage += done * done;
      for (std::size_t k = 0; k < parts; ++k) influence[k] += done * of[part_column(k)];
      for (int k = i + 1; k < count; ++k) z[k] -= done * factor.at(i, k);
    }
    const Lanes &w = places.weight[group], off = places.height[group] - fitted;
    squares += w * off * off;
    freedom += w - w * w * leverage;
    top_degree_dof += w * w * (leverage - below);
    for (std::size_t k = 0; k < parts; ++k) variance[k] += (w * influence[k]) * (w * influence[k]);
  }
  FitQuality quality;
  quality.squares = sum_of_lanes(squares);
  quality.freedom = sum_of_lanes(freedom);
  quality.top_degree_dof = sum_of_lanes(top_degree_dof);
  for (int i = last; i < count; ++i)
    quality.top_degree_squares += whitened.rows[i][heights_column] * whitened.rows[i][heights_column];
  for (std::size_t k = 0; k < parts; ++k) quality.variance[k] = sum_of_lanes(variance[k]);
  return quality;
}

}  // namespace integral_invariant
