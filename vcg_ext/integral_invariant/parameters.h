// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace integral_invariant {

/// How the radius of a vertex's ball is chosen.
enum class RadiusChoice {
  feature_adapted = 0,  ///< per vertex, by the iteration of [Lai09]
  fixed = 1,            ///< one radius for all vertices, as in [Yang06]
  statistical = 2,      ///< all scales, each weighted by what it shows over the noise (docs/method.md)
};

/// How a ball's moments become curvature.
enum class Estimator {
  yang06 = 0,       ///< [Yang06]
  offset_free = 1,  ///< the ball's centre may lie off the surface: far less sensitive to noise
  bias_free = 2,    ///< offset-free, and what grows with the radius is removed by comparing scales
};

/// What computes the moments of the balls.
enum class EngineKind {
  volume_fft = 0,        ///< convolutions on a voxel grid [Pottmann07, Lai09]; closed meshes only
  surface_integral = 1,  ///< exact sums over the triangles; open meshes too
};

/// How the radii between r_min and r_max are spaced.
enum class ScaleSpacing { linear = 0, geometric = 1 };

/// Where the iteration of the radius starts [Lai09 4.2].
enum class StartRadius {
  median = 0,  ///< the median over the scales of the smallest principal radius
  middle = 1,  ///< (r_min + r_max) / 2
};

/// How closely the surface engine's quadrature follows its closed forms.
enum class Exactness { fast = 0, balanced = 1, exact = 2 };

/// The ranges that validate() holds every caller to.
namespace limits {
inline constexpr int max_scales = 32;
inline constexpr double max_alpha = 10;
inline constexpr int max_iterations = 100000;
inline constexpr double max_tolerance = 0.5;
inline constexpr int max_smoothing_passes = 1000;
inline constexpr double min_cells_per_radius = 1, max_cells_per_radius = 64;
inline constexpr int max_threads = 1024;
}  // namespace limits

/// Everything that a run can be asked. The defaults are what measures best over all (docs/accuracy.md); the published
/// method is published_method(). Lengths are in the unit of the mesh; 0 means automatic where it says so.
struct Parameters {
  RadiusChoice radius_choice = RadiusChoice::statistical;
  Estimator estimator = Estimator::bias_free;
  double noise = 0;  ///< standard deviation of the surface's noise, L; 0: estimated
  EngineKind engine = EngineKind::surface_integral;

  int scales = 7;                               ///< number of radii n, 1 to 32
  ScaleSpacing spacing = ScaleSpacing::linear;  ///< statistical: always geometric
  double r_min = 0;   ///< smallest radius; 0: the average edge length ē (statistical: 1.5 ē)
  double r_max = 0;   ///< largest radius; 0: scales · ē, or scales · r_min if larger (statistical: 16 ē)
  double radius = 0;  ///< the fixed radius; 0: the middle of r_min and r_max

  double alpha = 0.9;  ///< wanted radius · max|κ| [Lai09 eq. 7], in (0, 10]
  double step = 0.1;   ///< λ of r ← r + λ(r′ − r) [Lai09 eq. 8], in (0, 1]
  StartRadius start_radius = StartRadius::median;
  int max_iterations = 200;  ///< 0 keeps the start radius
  double tolerance = 1e-3;   ///< relative change of the radius at which a vertex is done, in (0, 0.5]

  bool smooth_radius = true;  ///< bilateral smoothing of the radius [Lai09 eq. 9]
  int smoothing_passes = 1;

  double fft_cells_per_radius = 6;            ///< the grid step of a scale is its radius over this, in [1, 64]
  Exactness exactness = Exactness::balanced;  ///< surface engine only
  bool same_sheet = false;                    ///< surface engine only: the ball's connected piece of surface alone

  std::size_t memory_limit_mb = 0;  ///< 0: half of the machine's memory
  int threads = 0;                  ///< 0: all processors
};

/// The settings of [Lai09]: its estimator, and a radius adapted by its iteration.
Parameters published_method();

/// \throw ParameterError where a value is out of its range or not finite; names the parameter, the value and the range.
void validate(const Parameters& parameters);

}  // namespace integral_invariant
