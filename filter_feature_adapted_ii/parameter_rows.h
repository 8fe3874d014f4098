// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: how rows of the parameter tables are written, and the tables' parts.
#pragma once

#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "parameter_table.h"

namespace integral_invariant::filter {

inline constexpr double largest_int = std::numeric_limits<int>::max();

template <class Part>
auto& part_of(Request& request)
{
  if constexpr (std::is_same_v<Part, Parameters>)
    return request.method;
  else if constexpr (std::is_same_v<Part, OutputOptions>)
    return request.output;
  else if constexpr (std::is_same_v<Part, RidgeValleyParameters>)
    return request.ridge_valley;
  else if constexpr (std::is_same_v<Part, CrestLineParameters>)
    return request.crest;
  else if constexpr (std::is_same_v<Part, DirectionParameters>)
    return request.direction;
  else if constexpr (std::is_same_v<Part, LayerOptions>)
    return request.layer;
  else
    return request.signature;
}

/// How a member of a part of the request is read and written as a number.
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
  return {name,
          kind,
          unit,
          range.minimum,
          range.maximum,
          range.above_minimum,
          std::move(choices),
          words.label,
          words.tip,
          words.source,
          &Field<Member>::get,
          &Field<Member>::set,
          false};
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

inline ParameterSpec save_file(const char* name, const Words& words)
{
  return {name, Kind::save_file, "", 0, 0, false, {}, words.label, words.tip, words.source, nullptr, nullptr, false};
}

inline std::vector<ParameterSpec> joined(std::vector<ParameterSpec> rows, const std::vector<ParameterSpec>& more)
{
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

/// The table of "Compute Curvature by Integral Invariants per Vertex".
std::vector<ParameterSpec> curvature_rows();
/// The rows of the method that all filters that need curvatures share.
std::vector<ParameterSpec> shared_rows(std::initializer_list<const char*> names);

std::vector<ParameterSpec> ridge_valley_rows();
std::vector<ParameterSpec> crest_line_rows();
std::vector<ParameterSpec> direction_rows();
std::vector<ParameterSpec> signature_rows();

}  // namespace integral_invariant::filter
