// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of the method, and those of the output that filters share.
#include "method_parameters.h"

#include <stdexcept>
#include <string>

#include "integral_invariant/parameters.h"

namespace integral_invariant::filter {

namespace {

constexpr double largest_length =
    1e18;  // beyond the coordinates that meshes have; hosts keep numbers in single precision

using P = Parameters;

}  // namespace

std::vector<ParameterSpec> method_parameters()
{
  return {
      choice<&P::radius_choice>(
          "radius_choice", {"Feature-adapted", "Fixed", "Statistical"},
          {"Radius of the balls",
           "Feature-adapted: each vertex gets a ball as large as its feature allows, small on fine detail and large on "
           "flat parts. Fixed: all vertices get the same ball. Statistical: balls of all sizes at every vertex, each "
           "weighted by what it shows over the noise; the most accurate.",
           "[Lai09] 4.2, [Yang06], docs/method.md"}),
      choice<&P::estimator>(
          "estimator", {"Published", "Offset-free", "Bias removed"},
          {"Estimator",
           "How the part of the solid in a ball becomes curvature. Published: as in the paper. Offset-free: far less "
           "sensitive to noise, as it knows that the vertex itself is noisy. Bias removed: offset-free, and the errors "
           "of "
           "large balls are removed by comparing scales. A statistical radius needs one of the latter two.",
           "[Yang06], docs/method.md"}),
      real<&P::noise>("noise", "mesh", {0, largest_length},
                      {"Noise (0: estimated)",
                       "Standard deviation of the noise along the normal, if it is known. 0: estimated, place by "
                       "place. Used when the "
                       "radius is statistical.",
                       "docs/method.md"}),
      integer<&P::scales>("scales", "", {1, limits::max_scales},
                          {"Number of scales",
                           "How many radii are computed between the smallest and the largest; what lies between two of "
                           "them is blended. "
                           "Used unless the radius is fixed.",
                           "[Lai09] 4.1"}),
      length<&P::r_min>("r_min", {"Smallest radius",
                                  "Radius of the smallest ball. 0: the average edge length (statistical: 1.5 of it). "
                                  "With a feature-adapted radius, "
                                  "raise it for a noisy mesh.",
                                  "[Lai09] 4.1"}),
      length<&P::r_max>(
          "r_max",
          {"Largest radius",
           "Radius of the largest ball. 0: the number of scales times the average edge length (statistical: 16 of it).",
           "[Lai09] 4.1"}),
      length<&P::radius>(
          "radius",
          {"Fixed radius",
           "The one radius of all balls when the radius is fixed. 0: the middle of smallest and largest.", "[Yang06]"}),
      choice<&P::engine>(
          "engine", {"Volume (FFT)", "Surface integral"},
          {"Engine",
           "What measures the balls. Volume (FFT): convolutions on a voxel grid; the mesh must be closed. Surface "
           "integral: sums over the triangles without a grid; open meshes too.",
           "[Pottmann07], [Lai09] 4.1"}),
  };
}

std::vector<ParameterSpec> detail_parameters()
{
  std::vector<ParameterSpec> parameters = {
      choice<&P::spacing>("scale_spacing", {"Linear", "Geometric"},
                          {"Spacing of the scales",
                           "Linear: equal steps between the radii. Geometric: equal ratios, which reach a large radius "
                           "with few scales. A "
                           "statistical radius always takes equal ratios.",
                           "[Lai09] 4.1"}),
      real<&P::alpha>("alpha", "", {0, limits::max_alpha, true},
                      {"Radius times curvature (alpha)",
                       "The radius aimed at is this over the largest absolute curvature: smaller values follow finer "
                       "detail, larger "
                       "ones resist more noise.",
                       "[Lai09] eq. 7"}),
      real<&P::step>("step", "", {0, 1, true},
                     {"Step of the iteration (lambda)",
                      "The part of the way to the radius aimed at that one iteration goes.", "[Lai09] eq. 8"}),
      choice<&P::start_radius>(
          "start_radius", {"Median over the scales", "Middle of the range"},
          {"Start of the iteration",
           "Median: of the smallest principal radius over all scales. Middle: of the smallest and the largest radius.",
           "[Lai09] 4.2"}),
      integer<&P::max_iterations>(
          "max_iterations", "", {0, limits::max_iterations},
          {"Most iterations", "After so many steps a vertex keeps the radius it has; 0 keeps the start.",
           "[Lai09] 4.2"}),
      real<&P::tolerance>("tolerance", "", {0, limits::max_tolerance, true},
                          {"Tolerance", "A vertex is done when a step changes its radius by less than this part of it.",
                           "[Lai09] 4.2"}),
      boolean<&P::smooth_radius>(
          "smooth_radius",
          {"Smooth the radius",
           "Bilateral smoothing of the radius over the surface, which keeps the edges between features.",
           "[Lai09] eq. 9"}),
      integer<&P::smoothing_passes>("smoothing_passes", "", {0, limits::max_smoothing_passes},
                                    {"Smoothing passes", "How often the radius is smoothed.", "[Lai09] eq. 9"}),
      real<&P::fft_cells_per_radius>("fft_cells_per_radius", "cells",
                                     {limits::min_cells_per_radius, limits::max_cells_per_radius},
                                     {"Grid cells per radius",
                                      "Volume engine: each scale has a grid whose step is its radius over this, so the "
                                      "finest step is the smallest "
                                      "radius over it. Twice as many take about four to eight times as long.",
                                      "[Pottmann07], [Lai09] 4.1"}),
      choice<&P::exactness>("exactness", {"Fast", "Balanced", "Exact"},
                            {"Exactness", "Surface engine: how closely the sums follow the exact integrals."}),
      boolean<&P::same_sheet>("same_sheet", {"Same sheet only",
                                             "Surface engine: use only the piece of surface that is connected to the "
                                             "vertex inside the ball, for thin walls."}),
      integer<&P::memory_limit_mb>(
          "memory_limit_mb", "MB", {0, largest_int},
          {"Memory limit (MB; 0: automatic)", "The most memory that may be used; 0: half of the machine's."}),
  };
  for (ParameterSpec& spec : parameters) spec.advanced = true;
  return parameters;
}

std::vector<ParameterSpec> method_parameters(std::initializer_list<const char*> names)
{
  const std::vector<ParameterSpec> all = concatenate(method_parameters(), detail_parameters());
  std::vector<ParameterSpec> chosen;
  for (const char* name : names) {
    const ParameterSpec* spec = find_parameter(all, name);
    if (!spec) throw std::logic_error(std::string("The method has no parameter '") + name + "'.");
    chosen.push_back(*spec);
  }
  return chosen;
}

ParameterSpec color_percentile_parameter()
{
  return real<&OutputOptions::color_percentile>(
      "color_percentile", "%", {50, 100},
      {"Colour range (% of vertices)",
       "So many per cent of the vertices lie inside the colour range, which is symmetric about zero for signed "
       "quantities; the rest takes the end colours. 100: the whole range."});
}

}  // namespace integral_invariant::filter
