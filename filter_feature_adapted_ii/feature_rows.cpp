// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of the filters for features, directions and signatures.
#include "parameter_rows.h"

#include <string>

namespace integral_invariant::filter {

namespace {

using R = RidgeValleyParameters;
using C = CrestLineParameters;
using D = DirectionParameters;
using S = ReductionParameters;
using O = OutputOptions;

constexpr int most_passes = 100;
constexpr double largest_real = 1e30;  // hosts keep numbers in single precision

/// What decides the curvatures, for filters whose dialog has parameters of its own to show.
std::vector<ParameterSpec> curvature_source_rows()
{
  return shared_rows({"radius_choice", "estimator", "scales", "r_min", "r_max", "radius", "engine", "alpha",
                      "smooth_radius", "memory_limit_mb"});
}

ParameterSpec line_lift()
{
  return real<&LayerOptions::lift>(
      "lift", "average edges", {0, 1},
      {"Height over the surface (edges)",
       "Lines stand this many average edge lengths above the surface, so that it does not hide them. 0: on it."});
}

ParameterSpec line_export()
{
  return save_file(
      "export_file",
      {"Export to PLY",
       "Writes the lines as vertices and edges, with the properties ii_line, ii_kind and ii_strength of the vertices. "
       "Empty: no file."});
}

}  // namespace

std::vector<ParameterSpec> ridge_valley_rows()
{
  return joined(
      {
          boolean<&R::ridges>("ridges",
                              {"Ridges", "Select regions with a large positive maximal curvature.", "[Lai09] 5"}),
          boolean<&R::valleys>("valleys",
                               {"Valleys", "Select regions with a large negative minimal curvature.", "[Lai09] 5"}),
          choice<&R::threshold>("threshold", {"Percentile", "Curvature"},
                                {"Thresholds",
                                 "Percentile: relative to the largest absolute curvature of all vertices. Curvature: "
                                 "absolute, 1/length."}),
          real<&R::high_percentile>("high_percentile", "%", {0, 100},
                                    {"High threshold (percentile)",
                                     "A region needs a vertex that is stronger than this part of all vertices."}),
          real<&R::low_percentile>(
              "low_percentile", "%", {0, 100},
              {"Low threshold (percentile)",
               "A region grows over connected vertices that are stronger than this part of all vertices."}),
          real<&R::high_curvature>("high_curvature", "1/length", {0, largest_real},
                                   {"High threshold (curvature)",
                                    "The same as an absolute curvature; used when thresholds are curvatures."}),
          real<&R::low_curvature>(
              "low_curvature", "1/length", {0, largest_real},
              {"Low threshold (curvature)", "The same as an absolute curvature; 0: half of the high one."}),
          integer<&R::minimum_vertices>("minimum_vertices", "", {0, largest_int},
                                        {"Least vertices of a region", "Smaller regions are dropped."}),
          real<&R::minimum_area>("minimum_area", "length^2", {0, largest_real},
                                 {"Least area of a region", "Smaller regions are dropped."}),
          boolean<&O::colorize>("colorize", {"Colour the vertices", "Ridges red, valleys blue, the rest grey."}),
          save_file("export_file", {"Export to PLY",
                                    "Writes the mesh with the property ii_feature (1 ridge, -1 valley, 0 neither) and "
                                    "colours. Empty: no file."}),
      },
      curvature_source_rows());
}

std::vector<ParameterSpec> crest_line_rows()
{
  return joined(
      {
          boolean<&C::ridges>("ridges",
                              {"Ridge lines", "Lines where the maximal curvature is largest across the line."}),
          boolean<&C::valleys>("valleys",
                               {"Valley lines", "Lines where the minimal curvature is smallest across the line."}),
          real<&C::minimum_strength>("minimum_strength", "", {0, 1e6},
                                     {"Least strength",
                                      "The integral of the curvature along a line, which has no unit: 1 for a line as "
                                      "long as the radius that the "
                                      "surface bends with across it. Weaker lines are dropped."}),
          length<&C::minimum_length>("minimum_length",
                                     {"Least length", "Shorter lines are dropped. 0: five average edge lengths."}),
          real<&C::minimum_sharpness>("minimum_sharpness", "", {0, 100},
                                      {"Least sharpness",
                                       "How quickly the curvature falls beside a line, without unit: 0 for cylinders "
                                       "and spheres, up to 3 at the end of "
                                       "an ellipse. Less sharp lines are dropped."}),
          integer<&C::smoothing_passes>(
              "field_smoothing_passes", "", {0, most_passes},
              {"Smoothing of the curvatures",
               "How often curvatures are averaged over the mesh before lines are looked for."}),
          boolean<&O::colorize>("colorize", {"Colour the lines", "Ridges red, valleys blue."}),
          line_lift(),
          line_export(),
      },
      curvature_source_rows());
}

std::vector<ParameterSpec> direction_rows()
{
  return joined(
      {
          choice<&LayerOptions::style>("style", {"Lines of curvature", "Segments"},
                                       {"Style",
                                        "Lines of curvature: evenly spaced curves along the directions, which end at "
                                        "umbilics. Segments: short lines "
                                        "at vertices."}),
          boolean<&D::maximal>("maximal", {"Maximal curvature", "Directions of the maximal curvature."}),
          boolean<&D::minimal>("minimal", {"Minimal curvature", "Directions of the minimal curvature."}),
          length<&D::spacing>(
              "spacing",
              {"Spacing", "Distance between neighbouring lines, or between segments. 0: three average edge lengths."}),
          length<&D::segment_length>("segment_length", {"Length of segments", "0: eight tenths of the spacing."}),
          length<&D::minimum_length>(
              "minimum_length",
              {"Least length of lines", "Shorter lines of curvature are dropped. 0: twice the spacing."}),
          real<&D::umbilic>("umbilic", "", {0, 1},
                            {"Umbilic threshold",
                             "Lines end, and segments are left out, where the difference of the principal curvatures "
                             "is under this part of "
                             "their size: there is no direction there."}),
          integer<&D::smoothing_passes>("field_smoothing_passes", "", {0, most_passes},
                                        {"Smoothing of the curvatures",
                                         "How often curvatures are averaged over the mesh before lines are traced."}),
          boolean<&O::colorize>("colorize", {"Colour the lines", "Maximal curvature red, minimal curvature blue."}),
          line_lift(),
          line_export(),
      },
      curvature_source_rows());
}

std::vector<ParameterSpec> signature_rows()
{
  return joined(
      {
          choice<&S::quantity>("signature_quantity", {"Volume invariant", "Mean curvature", "Difference curvature"},
                               {"Quantity",
                                "What becomes the quality of the vertices. The volume invariant runs from -1 (all of "
                                "the ball solid) over 0 "
                                "(flat) to 1 (nothing solid). All three are stored as attributes in any case.",
                                "[Pottmann07], [Yang06]"}),
          choice<&S::reduction>("reduction", {"One scale", "Minimum", "Maximum", "p-norm"},
                                {"Reduction", "How the values of the scales become one."}),
          integer<&S::scale>(
              "scale", "", {1, limits::max_scales},
              {"Scale", "Which scale, from 1 (the smallest radius) to the number of scales, when it is one scale."}),
          real<&S::p>("p", "", {1, 100},
                      {"p of the p-norm", "1: mean of the absolute values; larger: nearer to the largest of them."}),
          boolean<&O::colorize>(
              "colorize",
              {"Colour the vertices", "Signed values: blue, white, red; others: from dark blue over green to yellow."}),
          shared_rows({"color_percentile"}).front(),
          save_file("export_file", {"Export to PLY",
                                    "Writes the mesh with the whole signature: ii_volume_1, ii_mean_1, ii_difference_1 "
                                    "and so on for every scale, "
                                    "and quality and colour. Empty: no file."}),
      },
      shared_rows({"scales", "r_min", "r_max", "scale_spacing", "engine", "fft_cells_per_radius", "exactness",
                   "memory_limit_mb"}));
}

}  // namespace integral_invariant::filter
