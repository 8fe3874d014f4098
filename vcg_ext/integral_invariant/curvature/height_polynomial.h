// SPDX-License-Identifier: GPL-3.0-or-later
// Stage 2: least squares fit of a height over a tangent plane by a polynomial, and the curvature of the graph.
#pragma once

#include <array>

#include "integral_invariant/curvature/tensor.h"

namespace integral_invariant {

/// Monomials x^i y^j by degree: 1; x, y; x², xy, y²; ... A leading part of them makes a polynomial of lower degree.
inline constexpr int largest_degree = 4;
constexpr int coefficient_count(int degree) { return (degree + 1) * (degree + 2) / 2; }
using Coefficients = std::array<double, coefficient_count(largest_degree)>;
using HeightMatrix = std::array<Coefficients, coefficient_count(largest_degree)>;
void monomials(double x, double y, int degree, Coefficients& result);

struct FitQuality;
struct HeightPlaces;

/// Normal equations of a weighted least squares fit.
class HeightSystem {
 public:
  HeightSystem() = default;
  /// Of all places at once. \pre they are complete for the degree
  HeightSystem(const HeightPlaces& places, int degree);
  /// One place of weight 1, of degree 2.
  void add(const Coefficients& monomials, double height);
  /// Factors the system of the largest degree, up to the one given, that the places determine, and returns it; 0 where
  /// they leave even a plane open. add() cannot follow.
  int factor(int degree);
  /// (AᵀWA)⁻¹ AᵀW h for the heights. \pre factor() returned at least `degree`
  Coefficients solution(int degree) const;
  /// Of the places that the system was made of, for a fit of the `degree` that factor() returned or less; `parts` are
  /// what multiplies the coefficients in quantities whose variance is asked for.
  FitQuality quality(const HeightPlaces& places, const std::array<const Coefficients*, 5>& parts, int degree) const;
  /// Σ w h² of the heights h that `solution` gives, from the sums: what it explains of theirs. Call on a system before
  /// factor().
  double explained(const Coefficients& solution, int degree) const;
  /// bᵀ (AᵀWA)⁻¹ b: with weights of 1, the variance of bᵀ·coefficients under heights of independent noise of variance
  /// 1.
  double inverse_form(Coefficients b, int degree) const;

 private:
  void forward(Coefficients& x, int count) const;

  /// Lower triangle; then its Cholesky factor there and above the diagonal, with the inverse of what is on the
  /// diagonal.
  HeightMatrix a_{};
  Coefficients b_{};
};

/// Parts of the curvature that depend linearly on the coefficients where the graph is level: what multiplies them.
namespace height_part {
inline constexpr Coefficients mean{0, 0, 0, 1, 0, 1}, deviator_a{0, 0, 0, 1, 0, -1}, deviator_b{0, 0, 0, 0, 1};
inline constexpr Coefficients slope_x{0, 1}, slope_y{0, 0, 1};
}  // namespace height_part

/// Orthonormal frame in which heights are measured along `normal`.
struct HeightFrame {
  explicit HeightFrame(const Vec3& up);
  Vec3 normal, x, y;
};

/// Curvature tensor and normal of the graph over the frame's origin; `unit` is the length that x and y were divided by.
CurvatureTensor graph_curvature(const Coefficients& heights, const HeightFrame& frame, double unit);

}  // namespace integral_invariant
