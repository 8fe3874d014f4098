// SPDX-License-Identifier: GPL-3.0-or-later
// Filter scripts in MeshLab's XML, and documentation.
#include "filter_script.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace integral_invariant::filter {

namespace {

std::string escaped(const std::string& text)
{
  std::string xml;
  for (const char c : text) {
    switch (c) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      case '"':
        xml += "&quot;";
        break;
      default:
        xml += c;
    }
  }
  return xml;
}

std::string attribute(const std::string& name, const std::string& value)
{
  return " " + name + "=\"" + escaped(value) + "\"";
}

const char* mlx_type(Kind kind)
{
  switch (kind) {
    case Kind::boolean:
      return "RichBool";
    case Kind::integer:
      return "RichInt";
    case Kind::real:
      return "RichFloat";
    case Kind::length:
      return "RichAbsPerc";
    case Kind::choice:
      return "RichEnum";
    case Kind::save_file:
      return "RichSaveFile";
  }
  return "";
}

/// MeshLab reads numbers in single precision, and 2020.09 aborts on one that this cannot hold.
void require_single_precision(const ParameterSpec& spec, double value)
{
  using Single = std::numeric_limits<float>;
  if (value == 0 || (std::abs(value) >= Single::min() && std::abs(value) <= Single::max())) return;
  throw ParameterError(
      "The parameter '" + std::string(spec.name) + "' is " + number_text(value) +
      ", but MeshLab reads numbers in single precision: 0, or from 1.2e-38 to 3.4e38 in size. Scale the "
      "mesh, and this parameter with it.");
}

std::string value_text(const ParameterSpec& spec, const Request& request)
{
  if (spec.kind == Kind::save_file) return spec.get_text(request);
  const double value = spec.get(request);
  if (spec.kind == Kind::boolean) return value != 0 ? "true" : "false";
  require_single_precision(spec, value);
  return number_text(value);
}

/// What the type needs besides the value: MeshLab refuses the script without it.
std::string type_attributes(const ParameterSpec& spec, const Request& request)
{
  std::string text;
  if (spec.kind == Kind::length)
    text = attribute("min", "0") + attribute("max", number_text(std::max(1.0, spec.get(request))));
  if (spec.kind == Kind::save_file) text = attribute("ext", std::string("*") + spec.choices.front());
  if (spec.kind == Kind::choice) {
    text = attribute("enum_cardinality", std::to_string(spec.choices.size()));
    for (std::size_t i = 0; i < spec.choices.size(); ++i)
      text += attribute("enum_val" + std::to_string(i), spec.choices[i]);
  }
  return text;
}

std::string default_text(const ParameterSpec& spec)
{
  const std::string value = value_text(spec, Request{});
  if (spec.kind == Kind::length) return "0 (automatic)";
  return value.empty() ? "empty" : value;
}

std::string unit_text(const ParameterSpec& spec)
{
  const std::string unit = spec.unit;
  return unit == "mesh" ? "unit of the mesh" : unit;
}

}  // namespace

void store_assignment(const Filter& filter, const std::string& assignment, Request& request)
{
  const std::size_t equals = assignment.find('=');
  const std::string name = assignment.substr(0, equals);
  const ParameterSpec* spec = find_parameter(filter.parameters, name);
  if (equals == std::string::npos) throw ParameterError("'" + assignment + "' is not of the form name=value.");
  if (spec) return store_from_text(*spec, assignment.substr(equals + 1), request);
  std::string names;
  for (const ParameterSpec& known : filter.parameters) names += (names.empty() ? "" : ", ") + std::string(known.name);
  throw ParameterError("There is no parameter '" + name + "'; the parameters are " + names + ".");
}

std::string filter_script(const Filter& filter, const Request& request)
{
  std::string xml = "<!DOCTYPE FilterScript>\n<FilterScript>\n <filter" + attribute("name", filter.name) + ">\n";
  for (const ParameterSpec& spec : filter.parameters)
    xml += "  <Param" + attribute("type", mlx_type(spec.kind)) + attribute("name", spec.name) +
           attribute("value", value_text(spec, request)) + type_attributes(spec, request) + "/>\n";
  return xml + " </filter>\n</FilterScript>\n";
}

std::string parameter_documentation(const Filter& filter)
{
  std::string text = "| Parameter | Default | Permitted | Unit | Meaning | Source |\n|---|---|---|---|---|---|\n";
  for (const ParameterSpec& spec : filter.parameters)
    text += "| `" + std::string(spec.name) + "` | " + default_text(spec) + " | " + range_text(spec) + " | " +
            unit_text(spec) + " | " + spec.label + ". " + spec.tip + " | " + spec.source + " |\n";
  return text;
}

std::string parameter_defaults(const Filter& filter)
{
  std::string text;
  for (const ParameterSpec& spec : filter.parameters)
    text += std::string(spec.name) + "=" + value_text(spec, Request{}) + "\n";
  return text;
}

}  // namespace integral_invariant::filter
