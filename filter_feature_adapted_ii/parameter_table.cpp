// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of the filter, and their validation.
#include "parameter_table.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

namespace integral_invariant::filter {

namespace {

constexpr double largest_int = std::numeric_limits<int>::max();

template <class Part>
auto& part_of(Request& request)
{
  if constexpr (std::is_same_v<Part, Parameters>) return request.method;
  else return request.output;
}

/// How a member of Parameters or OutputOptions is read and written as a number.
template <auto Member>
struct Field;
template <class Part, class Type, Type Part::*Member>
struct Field<Member> {
  static double get(const Request& request)
  {
    return static_cast<double>(part_of<Part>(const_cast<Request&>(request)).*Member);
  }
  static void set(Request& request, double value) { part_of<Part>(request).*Member = static_cast<Type>(value); }
};

struct Range {
  double minimum, maximum;
  bool above_minimum = false;
};

struct Words {
  const char *label, *tip, *source = "";
};

template <auto Member>
ParameterSpec row(const char* name, Kind kind, const char* unit, Range range, std::vector<const char*> choices,
                  const Words& words)
{
  return {name, kind, unit, range.minimum, range.maximum, range.above_minimum,
          std::move(choices), words.label, words.tip, words.source, &Field<Member>::get, &Field<Member>::set};
}

template <auto Member>
ParameterSpec boolean(const char* name, const Words& words)
{
  return row<Member>(name, Kind::boolean, "", {0, 1}, {}, words);
}

template <auto Member>
ParameterSpec integer(const char* name, const char* unit, Range range, const Words& words)
{
  return row<Member>(name, Kind::integer, unit, range, {}, words);
}

template <auto Member>
ParameterSpec real(const char* name, const char* unit, Range range, const Words& words)
{
  return row<Member>(name, Kind::real, unit, range, {}, words);
}

template <auto Member>
ParameterSpec length(const char* name, const Words& words)
{
  return row<Member>(name, Kind::length, "mesh", {0, std::numeric_limits<double>::infinity()}, {}, words);
}

template <auto Member>
ParameterSpec choice(const char* name, std::vector<const char*> choices, const Words& words)
{
  const Range range{0, static_cast<double>(choices.size()) - 1};
  return row<Member>(name, Kind::choice, "", range, std::move(choices), words);
}

ParameterSpec save_file(const char* name, const Words& words)
{
  return {name, Kind::save_file, "", 0, 0, false, {}, words.label, words.tip, words.source, nullptr, nullptr};
}

using P = Parameters;
using O = OutputOptions;

std::vector<ParameterSpec> method_rows()
{
  return {
      choice<&P::radius_choice>("radius_choice", {"Feature-adapted", "Fixed"},
          {"Radius of the balls",
           "Feature-adapted: each vertex gets a ball as large as its feature allows, small on fine detail and large on "
           "flat parts. Fixed: all vertices get the same ball.", "[Lai09] 4.2, [Yang06]"}),
      integer<&P::scales>("scales", "", {1, limits::max_scales},
          {"Number of scales",
           "How many radii are computed between the smallest and the largest; what lies between two of them is blended. "
           "Used when the radius is feature-adapted.", "[Lai09] 4.1"}),
      length<&P::r_min>("r_min",
          {"Smallest radius",
           "Radius of the smallest ball. 0: the average edge length. Raise it for a noisy mesh.", "[Lai09] 4.1"}),
      length<&P::r_max>("r_max",
          {"Largest radius",
           "Radius of the largest ball. 0: the number of scales times the average edge length.", "[Lai09] 4.1"}),
      length<&P::radius>("radius",
          {"Fixed radius",
           "The one radius of all balls when the radius is fixed. 0: the middle of smallest and largest.", "[Yang06]"}),
      choice<&P::engine>("engine", {"Volume (FFT)", "Surface integral"},
          {"Engine",
           "What measures the balls. Volume (FFT): convolutions on a voxel grid; the mesh must be closed. Surface "
           "integral: sums over the triangles without a grid; open meshes too.", "[Pottmann07], [Lai09] 4.1"}),
      choice<&P::spacing>("scale_spacing", {"Linear", "Geometric"},
          {"Spacing of the scales",
           "Linear: equal steps between the radii. Geometric: equal ratios, which reach a large radius with few scales.",
           "[Lai09] 4.1"}),
      real<&P::alpha>("alpha", "", {0, limits::max_alpha, true},
          {"Radius times curvature (alpha)",
           "The radius aimed at is this over the largest absolute curvature: smaller values follow finer detail, larger "
           "ones resist more noise.", "[Lai09] eq. 7"}),
      real<&P::step>("step", "", {0, 1, true},
          {"Step of the iteration (lambda)",
           "The part of the way to the radius aimed at that one iteration goes.", "[Lai09] eq. 8"}),
      choice<&P::start_radius>("start_radius", {"Median over the scales", "Middle of the range"},
          {"Start of the iteration",
           "Median: of the smallest principal radius over all scales. Middle: of the smallest and the largest radius.",
           "[Lai09] 4.2"}),
      integer<&P::max_iterations>("max_iterations", "", {0, limits::max_iterations},
          {"Most iterations", "After so many steps a vertex keeps the radius it has; 0 keeps the start.", "[Lai09] 4.2"}),
      real<&P::tolerance>("tolerance", "", {0, limits::max_tolerance, true},
          {"Tolerance", "A vertex is done when a step changes its radius by less than this part of it.", "[Lai09] 4.2"}),
      boolean<&P::smooth_radius>("smooth_radius",
          {"Smooth the radius",
           "Bilateral smoothing of the radius over the surface, which keeps the edges between features.", "[Lai09] eq. 9"}),
      integer<&P::smoothing_passes>("smoothing_passes", "", {0, limits::max_smoothing_passes},
          {"Smoothing passes", "How often the radius is smoothed.", "[Lai09] eq. 9"}),
      real<&P::fft_cells_per_radius>("fft_cells_per_radius", "cells",
          {limits::min_cells_per_radius, limits::max_cells_per_radius},
          {"Grid cells per radius",
           "Volume engine: each scale has a grid whose step is its radius over this, so the finest step is the smallest "
           "radius over it. Twice as many take about four to eight times as long.", "[Pottmann07], [Lai09] 4.1"}),
      choice<&P::exactness>("exactness", {"Fast", "Balanced", "Exact"},
          {"Exactness", "Surface engine: how closely the sums follow the exact integrals."}),
      boolean<&P::same_sheet>("same_sheet",
          {"Same sheet only",
           "Surface engine: use only the piece of surface that is connected to the vertex inside the ball, for thin walls."}),
      integer<&P::memory_limit_mb>("memory_limit_mb", "MB", {0, largest_int},
          {"Memory limit (MB; 0: automatic)", "The most memory that may be used; 0: half of the machine's."}),
      integer<&P::threads>("threads", "", {0, limits::max_threads},
          {"Threads (0: all)", "How many processors are used; 0: all. The result is the same with any number."}),
  };
}

std::vector<ParameterSpec> output_rows()
{
  return {
      choice<&O::quality>("quality",
          {"Mean curvature", "Gaussian curvature", "Maximal curvature", "Minimal curvature", "Shape index", "Curvedness",
           "Radius", "Largest absolute curvature"},
          {"Quality",
           "What is written into the quality of the vertices. Curvature is positive where the solid is convex. The shape "
           "index runs from -1 (cup) over 0 (saddle, flat) to 1 (cap)."}),
      boolean<&O::colorize>("colorize",
          {"Colour the vertices",
           "Signed quantities: blue for negative, white for zero, red for positive. The others: from dark blue (small) "
           "over green to yellow (large)."}),
      real<&O::color_percentile>("color_percentile", "%", {50, 100},
          {"Colour range (% of vertices)",
           "So many per cent of the vertices lie inside the colour range, which is symmetric about zero for signed "
           "quantities; the rest takes the end colours. 100: the whole range."}),
      save_file("export_file",
          {"Export to PLY",
           "Writes the mesh with every output as a property of its vertices (ii_kmax, ii_kmin, ii_radius, ii_confidence, "
           "ii_dirmax_x, ... , quality, colour), because MeshLab saves no curvature directions. Empty: no file."}),
  };
}

std::vector<ParameterSpec> all_rows()
{
  std::vector<ParameterSpec> rows = method_rows();
  // What the user looks at first comes right after the radii and the engine.
  const auto before_details = std::find_if(rows.begin(), rows.end(),
                                           [](const ParameterSpec& spec) { return std::string(spec.name) == "scale_spacing"; });
  const std::vector<ParameterSpec> output = output_rows();
  rows.insert(before_details, output.begin(), output.end());
  return rows;
}

[[noreturn]] void refuse(const ParameterSpec& spec, const std::string& value)
{
  throw ParameterError(std::string("The parameter '") + spec.name + "' is " + value + ", but must be " +
                       range_text(spec) + ".");
}

bool is_permitted(const ParameterSpec& spec, double value)
{
  if (!std::isfinite(value) || value < spec.minimum || value > spec.maximum) return false;
  if (spec.above_minimum && value == spec.minimum) return false;
  return spec.kind == Kind::real || spec.kind == Kind::length || value == std::floor(value);
}

std::string lower_case(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Not a number where `text` is none.
double parse_number(const std::string& text)
{
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end ? value : std::numeric_limits<double>::quiet_NaN();
}

double parse_value(const ParameterSpec& spec, const std::string& text)
{
  const std::string word = lower_case(text);
  if (spec.kind == Kind::boolean && (word == "true" || word == "false")) return word == "true";
  for (std::size_t i = 0; i < spec.choices.size(); ++i)
    if (word == lower_case(spec.choices[i])) return static_cast<double>(i);
  return parse_number(text);
}

}  // namespace

const std::vector<ParameterSpec>& parameter_table()
{
  static const std::vector<ParameterSpec> table = all_rows();
  return table;
}

const ParameterSpec* find_parameter(const std::string& name)
{
  for (const ParameterSpec& spec : parameter_table())
    if (name == spec.name) return &spec;
  return nullptr;
}

double default_value(const ParameterSpec& spec) { return spec.get ? spec.get(Request{}) : 0; }

std::string range_text(const ParameterSpec& spec)
{
  if (spec.kind == Kind::boolean) return "true or false";
  if (spec.kind == Kind::save_file) return "the name of a file ending in .ply, or empty";
  if (spec.kind == Kind::length) return "a length of at least 0 in the unit of the mesh (0: automatic)";
  if (spec.kind == Kind::choice) {
    std::string text;
    for (std::size_t i = 0; i < spec.choices.size(); ++i)
      text += (i ? ", " : "") + std::to_string(i) + " (" + spec.choices[i] + ")";
    return "one of " + text;
  }
  const std::string noun = spec.kind == Kind::integer ? "a whole number" : "a number";
  if (spec.maximum >= largest_int) return noun + " of at least " + number_text(spec.minimum);
  if (spec.above_minimum) return noun + " above " + number_text(spec.minimum) + " and at most " + number_text(spec.maximum);
  return noun + " from " + number_text(spec.minimum) + " to " + number_text(spec.maximum);
}

void store(const ParameterSpec& spec, double value, Request& request)
{
  if (!is_permitted(spec, value)) refuse(spec, number_text(value));
  spec.set(request, value);
}

void store_text(const ParameterSpec& spec, const std::string& text, Request& request)
{
  const bool is_ply = text.size() > 4 && lower_case(text.substr(text.size() - 4)) == ".ply";
  if (!text.empty() && !is_ply) refuse(spec, "'" + text + "'");
  request.output.export_file = text;
}

void store_from_text(const ParameterSpec& spec, const std::string& text, Request& request)
{
  if (spec.kind == Kind::save_file) return store_text(spec, text, request);
  const double value = parse_value(spec, text);
  if (!is_permitted(spec, value)) refuse(spec, "'" + text + "'");
  spec.set(request, value);
}

double as_typed(float value)
{
  if (!std::isfinite(value)) return static_cast<double>(value);
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, value);
  double result = 0;
  std::from_chars(text, written.ptr, result);
  return result;
}

std::string number_text(double value)
{
  char text[64];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace integral_invariant::filter
