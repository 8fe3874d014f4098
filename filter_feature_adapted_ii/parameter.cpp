// SPDX-License-Identifier: GPL-3.0-or-later
// Validation of values against the ranges of parameters.
#include "parameter.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

#include "parameter_list.h"
#include "utf8.h"

namespace integral_invariant::filter {

namespace {

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
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
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

/// ".svg, .pdf or .dxf"
std::string endings_text(const ParameterSpec& spec)
{
  std::string text = spec.choices.front();
  for (std::size_t i = 1; i < spec.choices.size(); ++i)
    text += std::string(i + 1 < spec.choices.size() ? ", " : " or ") + spec.choices[i];
  return text;
}

bool has_permitted_ending(const ParameterSpec& spec, const std::string& name)
{
  return std::any_of(spec.choices.begin(), spec.choices.end(), [&](const std::string& end) {
    return name.size() > end.size() && lower_case(name.substr(name.size() - end.size())) == end;
  });
}

}  // namespace

const ParameterSpec* find_parameter(const std::vector<ParameterSpec>& parameters, const std::string& name)
{
  for (const ParameterSpec& spec : parameters)
    if (name == spec.name) return &spec;
  return nullptr;
}

double default_value(const ParameterSpec& spec) { return spec.get ? spec.get(Request{}) : 0; }

std::string range_text(const ParameterSpec& spec)
{
  if (spec.kind == Kind::boolean) return "true or false";
  if (spec.kind == Kind::save_file) return "the name of a file ending in " + endings_text(spec) + ", or empty";
  if (spec.kind == Kind::length) return "a length of at least 0 in the unit of the mesh (0: automatic)";
  if (spec.kind == Kind::choice) {
    std::string text;
    for (std::size_t i = 0; i < spec.choices.size(); ++i)
      text += (i ? ", " : "") + std::to_string(i) + " (" + spec.choices[i] + ")";
    return "one of " + text;
  }
  const std::string noun = spec.kind == Kind::integer ? "a whole number" : "a number";
  if (spec.maximum >= largest_int) return noun + " of at least " + number_text(spec.minimum);
  if (spec.above_minimum)
    return noun + " above " + number_text(spec.minimum) + " and at most " + number_text(spec.maximum);
  return noun + " from " + number_text(spec.minimum) + " to " + number_text(spec.maximum);
}

void store(const ParameterSpec& spec, double value, Request& request)
{
  if (!is_permitted(spec, value)) refuse(spec, number_text(value));
  spec.set(request, value);
}

void require_permitted(const ParameterSpec& spec, const Request& request)
{
  const double value = spec.get(request);
  if (!is_permitted(spec, value)) refuse(spec, number_text(value));
}

void store_text(const ParameterSpec& spec, const std::string& text, Request& request)
{
  const bool has_control =
      std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  if (!is_utf8(text) || has_control) refuse(spec, "not UTF-8 without control characters");
  if (!text.empty() && !has_permitted_ending(spec, text)) refuse(spec, "'" + text + "'");
  spec.set_text(request, text);
}

void store_from_text(const ParameterSpec& spec, const std::string& text, Request& request)
{
  if (spec.kind == Kind::save_file) return store_text(spec, text, request);
  const double value = parse_value(spec, text);
  if (!is_permitted(spec, value)) refuse(spec, "'" + text + "'");
  spec.set(request, value);
}

double undo_float_rounding(float value)
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
