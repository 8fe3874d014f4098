// SPDX-License-Identifier: GPL-3.0-or-later
// Compute Multi-Scale Integral Invariant Signature.
#include "integral_invariant/features/signature.h"
#include "integral_invariant/parameters.h"
#include "integral_invariant/curvature.h"
#include "method_parameters.h"
#include "registry.h"
#include "report.h"

namespace integral_invariant::filter {

namespace {

using S = ReductionParameters;

constexpr const char* help = R"(Computes integral invariants of every vertex at <b>all scales</b>: the volume invariant
1 &minus; 2V / (4/3 &pi;r<sup>3</sup>), V the solid's part of the ball, which runs from &minus;1 (all solid) over 0 (flat) to 1
(nothing solid), and the mean and the difference of the principal curvatures. They are stored as vertex attributes ii_volume_1,
ii_mean_1, ii_difference_1 and so on from the smallest scale, and one number made of a quantity's scales becomes
the quality: the value at one scale, the minimum, the maximum, or the p-norm. Faint relief, such as worn inscriptions, shows at
scales of its own depth.<br/>
See: <i>H. Pottmann, J. Wallner, Y.-L. Yang, Y.-K. Lai, S.-M. Hu</i>, <b>"Principal curvatures from the integral invariant
viewpoint"</b>, <a href="https://doi.org/10.1016/j.cagd.2007.07.004">CAGD 24, 2007</a>.)";

std::vector<ParameterSpec> parameters()
{
  return concatenate(
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
          boolean<&OutputOptions::colorize>(
              "colorize",
              {"Colour the vertices", "Signed values: blue, white, red; others: from dark blue over green to yellow."}),
          color_percentile_parameter(),
          save_file<&OutputOptions::export_file>(
              "export_file", {"Export to PLY",
                              "Writes the mesh with the whole signature: ii_volume_1, ii_mean_1, ii_difference_1 "
                              "and so on for every scale, "
                              "and quality and colour. Empty: no file."}),
      },
      method_parameters({"scales", "r_min", "r_max", "scale_spacing", "engine", "fft_cells_per_radius", "exactness",
                         "memory_limit_mb"}));
}

/// The attributes ii_volume_1, ii_mean_1, ... of a signature.
std::vector<NamedValues> signature_attributes(const Signature& signature)
{
  const char* const names[signature_quantity_count] = {"ii_volume_", "ii_mean_", "ii_difference_"};
  std::vector<NamedValues> attributes;
  for (int q = 0; q < signature_quantity_count; ++q)
    for (std::size_t s = 0; s < signature.radii.size(); ++s)
      attributes.push_back({names[q] + std::to_string(s + 1), signature.values[q][s]});
  return attributes;
}

/// Signs mean something but for differences and norms, whose colours are those of a magnitude.
Quantity coloured_like(const ReductionParameters& p)
{
  const bool magnitude = p.quantity == SignatureQuantity::difference || p.reduction == Reduction::p_norm;
  return magnitude ? Quantity::curvedness : Quantity::mean;
}

/// What the log of any run tells.
Result run_of(const Signature& signature)
{
  Result run;
  run.surface = signature.surface;
  run.scales = signature.radii;
  run.average_edge = signature.average_edge;
  run.diagonal = signature.diagonal;
  run.engine = signature.engine;
  run.stages = signature.stages;
  return run;
}

void add_report(const Signature& signature, FilterResult& result)
{
  const Result run = run_of(signature);
  const Statistics s = statistics(result.quality);
  result.log = {"Multi-scale signature"};
  for (const auto& lines : {run_lines(run), defect_lines(run)})
    result.log.insert(result.log.end(), lines.begin(), lines.end());
  result.log.push_back(quality_line("", s));
  result.log.push_back(time_line(run));
  result.values = {{"scales", int(run.scales.size())}, {"quality_min", s.minimum}, {"quality_p5", s.p5},
                   {"quality_median", s.median},       {"quality_p95", s.p95},     {"quality_max", s.maximum},
                   {"average_edge", run.average_edge}, {"engine", run.engine}};
}

/// No stage of it depends on the order of the mesh.
FilterResult run(const FilterInput& input, const ProgressCallback& progress)
{
  const auto& p = input.request.part<ReductionParameters>();
  const auto& method = input.request.part<Parameters>();
  if (p.reduction == Reduction::one_scale && p.scale > method.scales)
    throw ParameterError("The parameter 'scale' is " + std::to_string(p.scale) + ", but there are " +
                         std::to_string(method.scales) + " scales (parameter 'scales').");
  const Signature signature = compute_signature(input.mesh, method, progress);

  FilterResult result;
  result.quality = reduce(signature, p);
  const auto& output = input.request.part<OutputOptions>();
  const Quantity like = coloured_like(p);
  const ColorRange range = color_range(result.quality, like, output.color_percentile);
  if (output.colorize)
    for (const double value : result.quality) result.colors.push_back(color_of(value, range, like));
  result.attributes = signature_attributes(signature);
  add_report(signature, result);
  return result;
}

}  // namespace

const Filter& signature_filter()
{
  static const Filter filter{"Compute Multi-Scale Integral Invariant Signature",
                             "compute_multi_scale_integral_invariant_signature",
                             help,
                             menu_quality | menu_vertex_colors,
                             field_quality | field_color,
                             parameters(),
                             run};
  return filter;
}

}  // namespace integral_invariant::filter
