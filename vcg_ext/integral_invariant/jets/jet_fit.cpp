// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: polynomial fits to vertices. In: surface, rough normals. Out: tensors, their variances, residuals.
// Cost: about 3 µs a fit to the nearest vertices, 15 µs a disc of 16 ē. Source: docs/method.md §6.
#include "integral_invariant/jets/jet_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "integral_invariant/ball_curvature/tangent_frame.h"
#include "integral_invariant/support/pi.h"

namespace integral_invariant {

namespace {

constexpr int disc_degree = 2, least_degree = 2;

/// Variances of what a fit says, from those of its parts, which `variance_of` gives.
template <class VarianceOf>
void set_variances(const VarianceOf& variance_of, double unit, Jet& fit)
{
  const double unit2 = unit * unit, unit4 = unit2 * unit2;
  fit.mean_variance = variance_of(mean_part) / unit4;
  fit.deviator_variance = (variance_of(deviator_a_part) + variance_of(deviator_b_part)) / (2 * unit4);
  fit.normal_variance = (variance_of(slope_x_part) + variance_of(slope_y_part)) / (2 * unit2);
}

}  // namespace

double standard_error(const Jet& fit)
{
  if (!(fit.residual_variance >= 0)) return INFINITY;
  return std::sqrt(fit.residual_variance * (fit.mean_variance + fit.deviator_variance));
}

JetFitter::JetFitter(const Surface& surface, const std::vector<char>& barrier)
    : surface_(surface), barrier_(barrier.empty() ? nullptr : &barrier), seen_(surface.vertex_count(), 0)
{
}

JetFitter::Place JetFitter::place_of(std::uint32_t u, const Vec3& centre, const HeightFrame& frame) const
{
  const Vec3 d = surface_.positions()[u] - centre;
  const double x = dot(d, frame.x), y = dot(d, frame.y);
  return {x * x + y * y, x, y, dot(d, frame.normal), u};
}

void JetFitter::start_at(std::size_t v)
{
  ++stamp_;
  seen_[v] = stamp_;
  queue_.assign(1, std::uint32_t(v));
  places_.clear();
}

/// The vertex, its neighbours and their neighbours: on a surface with creases more is not better. Further rings where
/// these are few, as at a boundary: half a disc of three rows does not tell a cubic. Not by way of the hubs of large
/// fans, whose neighbours are mostly far away: their number squared would be the work.
void JetFitter::walk_rings(std::size_t v, const HeightFrame& frame, std::size_t least_count)
{
  constexpr int rings = 2, most_rings = 4;
  constexpr std::uint32_t most_spokes = 512;
  const Vec3& centre = surface_.positions()[v];
  start_at(v);
  std::size_t next = 0;
  for (int ring = 0; ring <= most_rings; ++ring) {
    const bool is_last = ring == most_rings || (ring >= rings && queue_.size() >= least_count);
    for (const std::size_t end = queue_.size(); next < end; ++next) {
      const std::uint32_t u = queue_[next];
      places_.push_back(place_of(u, centre, frame));
      const std::uint32_t begin_spokes = surface_.neighbour_start()[u], end_spokes = surface_.neighbour_start()[u + 1];
      if (is_last || (u != v && end_spokes - begin_spokes > most_spokes)) continue;
      for (std::uint32_t e = begin_spokes; e < end_spokes; ++e) {
        const std::uint32_t w = surface_.neighbours()[e];
        if (seen_[w] == stamp_) continue;
        seen_[w] = stamp_;
        queue_.push_back(w);
      }
    }
    if (is_last) break;
  }
}

Jet JetFitter::nearest(std::size_t v, const Vec3& normal)
{
  constexpr JetKind usual{4, 20, 14, 4};
  return fit_k_nearest(v, normal, usual);
}

Jet JetFitter::finest(std::size_t v, const Jet& usual)
{
  constexpr JetKind near{4, 18, 18, 6}, far{6, 36, 36, 6};
  static_assert(far.count <= HeightPlaces::capacity && far.degree <= largest_degree);
  constexpr double usual_handicap = 2, least_error = 1e-9;  // polynomials that are exact have rounding left
  constexpr double small_share = 0.001, large_share = 0.01;
  if (standard_error(usual) <= least_error) return usual;
  const auto has_error_under = [](const Jet& fit, double share) {
    return standard_error(fit) <= share * largest_absolute_curvature(fit.tensor);
  };
  Jet best = fit_k_nearest(v, usual.tensor.normal, far);
  if (!has_error_under(best, small_share)) {
    const Jet of_few = fit_k_nearest(v, usual.tensor.normal, near);
    if (standard_error(of_few) < standard_error(best)) best = of_few;
  }
  if (!(standard_error(best) < usual_handicap * standard_error(usual))) best = usual;
  return has_error_under(best, large_share) ? best : fit_one_side(v, best);
}

Jet JetFitter::fit_one_side(std::size_t v, const Jet& of_all_sides)
{
  constexpr JetKind half{4, 20, 44, 3};
  constexpr int sides = 8;
  constexpr double slack = 0.05;
  constexpr double largest_share = 0.3;  // of the error: out of eight one is small by chance
  constexpr double largest_fold = 0.02;  // an angle between the two sides
  const HeightFrame frame(of_all_sides.tensor.normal);
  walk_rings(v, frame, half.least_count);
  const std::vector<Place> around = places_;
  std::array<Jet, sides> fits;
  // From a direction that turns with the surface.
  const Vec3 axis = principal_curvatures(of_all_sides.tensor).dir_max;
  const double first = std::atan2(dot(axis, frame.y), dot(axis, frame.x));
  for (int side = 0; side < sides; ++side) {
    const double angle = first + 2 * pi * side / sides, x = std::cos(angle), y = std::sin(angle);
    places_.clear();
    std::copy_if(around.begin(), around.end(), std::back_inserter(places_),
                 [&](const Place& p) { return p.x * x + p.y * y > -slack; });
    fits[std::size_t(side)] = fit_places(frame, half);
  }
  const auto best = std::min_element(fits.begin(), fits.end(),
                                     [](const Jet& a, const Jet& b) { return standard_error(a) < standard_error(b); });
  const Jet& opposite = fits[std::size_t(best - fits.begin() + sides / 2) % sides];
  const bool is_fold = norm(cross(best->tensor.normal, opposite.tensor.normal)) > largest_fold;
  return !is_fold && standard_error(*best) < largest_share * standard_error(of_all_sides) ? *best : of_all_sides;
}

Jet JetFitter::fit_k_nearest(std::size_t v, const Vec3& normal, const JetKind& kind)
{
  const HeightFrame frame(normal);
  walk_rings(v, frame, kind.least_count);
  return fit_places(frame, kind);
}

Jet JetFitter::fit_places(const HeightFrame& frame, const JetKind& kind)
{
  if (places_.empty()) return {};
  const std::size_t count = std::min(places_.size(), kind.count);
  std::nth_element(places_.begin(), places_.begin() + std::ptrdiff_t(count - 1), places_.end(),
                   [](const Place& p, const Place& q) { return p.squared_distance < q.squared_distance; });
  places_.resize(count);
  const double squared_unit = places_.back().squared_distance, unit = std::sqrt(squared_unit);
  if (!(unit > 0)) return {};
  int degree = kind.degree;
  while (degree >= least_degree && int(count) <= coefficient_count(degree)) --degree;
  if (degree < least_degree) return {};
  heights_in_lanes_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Place& p = places_[i];
    const double weight = std::exp(-kind.weight_fall * p.squared_distance / squared_unit);
    heights_in_lanes_.set(i, p.x / unit, p.y / unit, p.height, weight);
  }
  heights_in_lanes_.complete(degree);
  const HeightFit polynomial(sums_of(heights_in_lanes_, degree), degree);
  if (polynomial.degree() < least_degree) return {};

  Jet fit;
  fit.tensor = graph_curvature(polynomial.coefficients(), frame, unit);
  fit.support_radius = unit;
  const FitQuality quality = polynomial.quality(heights_in_lanes_);
  set_variances([&](HeightPart part) { return quality.variance[part]; }, unit, fit);
  constexpr double least_freedom = 0.1;
  if (quality.freedom > least_freedom) fit.residual_variance = quality.squares / quality.freedom;
  if (quality.top_degree_dof > least_freedom)
    fit.top_degree_variance = quality.top_degree_squares / quality.top_degree_dof;
  return fit;
}

/// Marks the neighbours in a part of the list as seen, and returns how many were not; without a branch, for who is new
/// cannot be foreseen.
std::size_t JetFitter::find_unseen(std::uint32_t begin, std::uint32_t end, std::uint32_t* unseen)
{
  const std::uint32_t* const neighbours = surface_.neighbours().data();
  std::size_t count = 0;
  for (std::uint32_t e = begin; e < end; ++e) {
    const std::uint32_t w = neighbours[e];
    unseen[count] = w;
    count += seen_[w] != stamp_;
    seen_[w] = stamp_;
  }
  return count;
}

void JetFitter::begin_disc(std::size_t v, const Vec3& normal)
{
  start_at(v);
  queue_.clear();
  frame_ = HeightFrame(normal);
  centre_ = surface_.positions()[v];
  sums_ = {};
  taken_.clear();
  beyond_.assign(1, {0, 0, 0, 0, std::uint32_t(v)});
}

void JetFitter::take_into_disc(const Place& place)
{
  taken_.add(place.x, place.y, place.height);
  queue_.push_back(place.vertex);
}

Jet JetFitter::extend_disc(double radius)
{
  constexpr std::size_t least_count = 10;
  constexpr std::uint32_t few = 16;  // of a hub's spokes at a time
  // Half more than what a mesh of even edges has in the largest ball. Where vertices are as dense
  // as that, smaller discs have all that is needed, and larger ones would take the square of the density.
  constexpr std::size_t most_count = 1536;
  const double squared_radius = radius * radius;
  // Heights count too: where the surface turns away it is no graph.
  constexpr double steepest = 2;
  const auto is_within = [&](const Place& p) {
    return p.squared_distance <= squared_radius && p.height * p.height <= steepest * steepest * squared_radius;
  };
  const auto is_full = [&] { return std::size_t(sums_.powers[0]) + taken_.count > most_count; };
  if (is_full()) return {};
  const auto first_within =
      std::partition(beyond_.begin(), beyond_.end(), [&](const Place& p) { return !is_within(p); });
  for (auto p = first_within; p != beyond_.end(); ++p) take_into_disc(*p);
  beyond_.erase(first_within, beyond_.end());
  for (std::size_t next = 0; next < queue_.size() && !is_full(); ++next) {
    const std::uint32_t u = queue_[next], end = surface_.neighbour_start()[u + 1];
    for (std::uint32_t e = surface_.neighbour_start()[u]; e < end && !is_full(); e += few) {
      std::array<std::uint32_t, few> fresh;
      const std::size_t fresh_count = find_unseen(e, std::min(e + few, end), fresh.data());
      for (std::size_t i = 0; i < fresh_count; ++i) {
        if (barrier_ && (*barrier_)[fresh[i]]) continue;
        const Place place = place_of(fresh[i], centre_, frame_);
        if (is_within(place))
          take_into_disc(place);
        else
          beyond_.push_back(place);
      }
    }
  }
  queue_.clear();
  add_to_quadric_sums(taken_, sums_);
  taken_.clear();

  const double count = sums_.powers[0];
  if (count < double(least_count) || is_full()) return {};
  const HeightFit quadric(sums_, disc_degree);
  if (quadric.degree() < disc_degree) return {};
  Jet fit;
  fit.support_radius = radius;
  fit.centroid_offset = std::hypot(sums_.powers[1], sums_.powers[2]) / (count * radius);
  fit.tensor = graph_curvature(quadric.coefficients(), frame_, 1);
  fit.residual_variance = quadric.squares() / (count - coefficient_count(disc_degree));
  set_variances([&](HeightPart part) { return quadric.variance(part); }, 1, fit);
  const auto c = [&](HeightPart a, HeightPart b) { return quadric.covariance(a, b); };
  disc_covariance_ = {c(mean_part, mean_part),
                      c(mean_part, deviator_a_part),
                      c(mean_part, deviator_b_part),
                      c(deviator_a_part, deviator_a_part),
                      c(deviator_a_part, deviator_b_part),
                      c(deviator_b_part, deviator_b_part)};
  return fit;
}

Symmetric3 JetFitter::disc_covariance(const Vec3& axis) const
{
  return rotate_covariance(disc_covariance_, dot(axis, frame_.x), dot(axis, frame_.y));
}

std::vector<Vec3> patch_normals(const Surface& surface, Execution& execution)
{
  const std::vector<Vec3>& p = surface.positions();
  std::vector<Vec3> areas, normals;
  resize_in_steps(areas, p.size(), execution);
  resize_in_steps(normals, p.size(), execution);
  for_each_in_order(surface.triangles().size(), execution, [&](std::size_t i) {
    const Triangle& t = surface.triangles()[i];
    const Vec3 area = cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
    for (const int v : t) areas[v] += area;
  });
  for_each_index(p.size(), execution, [&](std::size_t v) {
    normals[v] = areas[v];
    for (std::uint32_t e = surface.neighbour_start()[v]; e < surface.neighbour_start()[v + 1]; ++e)
      normals[v] += areas[surface.neighbours()[e]];
    normals[v] = normalized(normals[v]);
  });
  return normals;
}

Vec3 rough_normal(const TensorField& tensors, std::size_t v, const Vec3& patch)
{
  constexpr double least_cosine = 0.9;
  constexpr int usual_scale = 3;
  constexpr double largest_kr = 0.8;
  int scale = std::min(usual_scale, int(tensors.radii().size()) - 1);
  CurvatureTensor t = tensors.at_scale(v, scale);
  while (scale > 0 && largest_absolute_curvature(t) * tensors.radii()[std::size_t(scale)] > largest_kr)
    t = tensors.at_scale(v, --scale);
  if (largest_absolute_curvature(t) * tensors.radii()[std::size_t(scale)] > largest_kr)
    t = tensors.at_scale(v, std::min(usual_scale, int(tensors.radii().size()) - 1));
  return dot(t.normal, patch) < least_cosine ? patch : t.normal;
}

std::vector<Jet> fit_jets(const Surface& surface, const TensorField& tensors, Execution& execution)
{
  std::vector<Jet> fits;
  resize_in_steps(fits, surface.vertex_count(), execution);
  const std::vector<Vec3> normals = patch_normals(surface, execution);
  JetFitters fitters(surface, execution);
  parallel_for(fits.size(), 512, execution, [&](std::size_t begin, std::size_t end, int worker) {
    JetFitter& fitter = fitters.of(worker);
    for (std::size_t v = begin; v < end; ++v)
      if (surface.is_referenced(v)) fits[v] = fitter.nearest(v, rough_normal(tensors, v, normals[v]));
  });
  return fits;
}

}  // namespace integral_invariant
