// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: one parameter of a filter. The dialogs, the filter scripts, the documentation
// and the validation of what scripts hand over all come from the filters' lists of these.
#pragma once

#include <string>
#include <vector>

#include "integral_invariant/error.h"
#include "request.h"

namespace integral_invariant::filter {

enum class Kind { boolean, integer, real, length, choice, save_file };

/// One parameter. Numbers of all kinds are double here; a choice is its index.
struct ParameterSpec {
  const char* name;
  Kind kind;
  const char* unit;                  ///< "" where it has none; "mesh" for lengths in the unit of the mesh
  double minimum, maximum;           ///< of the value; infinite where there is none
  bool above_minimum;                ///< the minimum itself is not permitted
  std::vector<const char*> choices;  ///< of a choice, by index; of a save_file, the ends of names: ".ply"
  const char* label;                 ///< short, for the dialog
  const char* tip;                   ///< one or two sentences
  const char* source;                ///< where in the literature it comes from; "" where it is this project's
  double (*get)(const Request&);     ///< null for a save_file
  void (*set)(Request&, double);
  const std::string& (*get_text)(const Request&);  ///< of a save_file; null for numbers
  void (*set_text)(Request&, const std::string&);
  bool advanced;  ///< dialogs that can fold rows away show this one on request only
};

/// The parameter of that name, or null.
const ParameterSpec* find_parameter(const std::vector<ParameterSpec>& parameters, const std::string& name);

/// The value of an unchanged request: the default stands once, in the struct that the parameter
/// is a member of. 0 for a save_file.
double default_value(const ParameterSpec& spec);

/// The permitted values as text: "a number above 0 and at most 1", "one of 0 (Fast), 1 (Balanced), ...".
std::string range_text(const ParameterSpec& spec);

/// Checks `value` and lets it land in `request`. \throw ParameterError naming parameter, value and range
void store(const ParameterSpec& spec, double value, Request& request);
void store_text(const ParameterSpec& spec, const std::string& text, Request& request);

/// What `store` checks, of a request that was filled in by other means. \throw ParameterError
void require_permitted(const ParameterSpec& spec, const Request& request);

/// Reads `text` as a value of the parameter (a choice by index or label) and stores it. \throw ParameterError
void store_from_text(const ParameterSpec& spec, const std::string& text, Request& request);

/// The number that a person typed when a host kept it in single precision: 0.9, not 0.89999998. All hosts then compute
/// with the same parameters, to the bit.
double undo_float_rounding(float value);
/// PyMeshLab computes in double precision, but hands many parameters on in single.
inline double undo_float_rounding(double value)
{
  const float single = static_cast<float>(value);
  return static_cast<double>(single) == value ? undo_float_rounding(single) : value;
}

/// The shortest text that reads back as `value`.
std::string number_text(double value);

}  // namespace integral_invariant::filter
