// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: how the parameters of a filter are written down.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "parameter.h"

namespace integral_invariant::filter {

inline constexpr double largest_int = std::numeric_limits<int>::max();

/// How a member of a part of the request is read and written as a number.
template <auto Member>
struct Field;
template <class Part, class Type, Type Part::*Member>
struct Field<Member> {
  static double get(const Request& request) { return static_cast<double>(request.part<Part>().*Member); }
  static void set(Request& request, double value) { request.part<Part>().*Member = static_cast<Type>(value); }
};

/// The same of a member that is a text.
template <auto Member>
struct TextField;
template <class Part, std::string Part::*Member>
struct TextField<Member> {
  static const std::string& get(const Request& request) { return request.part<Part>().*Member; }
  static void set(Request& request, const std::string& text) { request.part<Part>().*Member = text; }
};

struct Range {
  double minimum, maximum;
  bool above_minimum = false;
};

struct Text {
  const char *label, *tip, *source = "";
};

template <auto Member>
ParameterSpec number(const char* name, Kind kind, const char* unit, Range range, std::vector<const char*> choices,
                     const Text& text)
{
  return {name,
          kind,
          unit,
          range.minimum,
          range.maximum,
          range.above_minimum,
          std::move(choices),
          text.label,
          text.tip,
          text.source,
          &Field<Member>::get,
          &Field<Member>::set,
          nullptr,
          nullptr,
          false};
}

template <auto Member>
ParameterSpec boolean(const char* name, const Text& text)
{
  return number<Member>(name, Kind::boolean, "", {0, 1}, {}, text);
}

template <auto Member>
ParameterSpec integer(const char* name, const char* unit, Range range, const Text& text)
{
  return number<Member>(name, Kind::integer, unit, range, {}, text);
}

template <auto Member>
ParameterSpec real(const char* name, const char* unit, Range range, const Text& text)
{
  return number<Member>(name, Kind::real, unit, range, {}, text);
}

template <auto Member>
ParameterSpec length(const char* name, const Text& text)
{
  return number<Member>(name, Kind::length, "mesh", {0, std::numeric_limits<double>::infinity()}, {}, text);
}

template <auto Member>
ParameterSpec choice(const char* name, std::vector<const char*> choices, const Text& text)
{
  const Range range{0, static_cast<double>(choices.size()) - 1};
  return number<Member>(name, Kind::choice, "", range, std::move(choices), text);
}

/// `endings`: of the file's name, with their dot; the dialog offers the first.
template <auto Member>
ParameterSpec save_file(const char* name, const Text& text, std::vector<const char*> endings = {".ply"})
{
  using Access = TextField<Member>;
  return {name,       Kind::save_file, "",          0,       0,       false,        std::move(endings),
          text.label, text.tip,        text.source, nullptr, nullptr, &Access::get, &Access::set,
          false};
}

inline std::vector<ParameterSpec> concatenate(std::vector<ParameterSpec> first, const std::vector<ParameterSpec>& more)
{
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

}  // namespace integral_invariant::filter
