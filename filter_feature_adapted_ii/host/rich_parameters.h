// SPDX-License-Identifier: GPL-3.0-or-later
// What both plugin interfaces share: a filter's parameters as MeshLab's parameter classes, and back.
#pragma once

#include <type_traits>
#include <utility>
#include <vector>

#include "../filter.h"

#if __has_include(<common/parameters/rich_parameters.h>)
#include <common/parameters/rich_parameters.h>
namespace integral_invariant::filter {
using RichLength = RichPercentage;
using RichFile = RichFileSave;
}  // namespace integral_invariant::filter
#else
namespace integral_invariant::filter {
using RichLength = RichAbsPerc;
using RichFile = RichSaveFile;
}  // namespace integral_invariant::filter
#endif

namespace integral_invariant::filter {

/// The tip with the unit, the permitted values and the source, which no dialog shows otherwise.
inline QString tooltip(const ParameterSpec& spec)
{
  QString text = spec.tip;
  if (spec.kind == Kind::integer || spec.kind == Kind::real)
    text +=
        QString(" Permitted: ") + range_text(spec).c_str() + (*spec.unit ? QString(" ") + spec.unit : QString()) + ".";
  if (*spec.source) text += QString(" ") + spec.source + ".";
  return text;
}

/// Adds a parameter of class Rich. The dialogs of 2021.05 and later show advanced ones on request only; that of 2020.09
/// shows all.
template <class Rich, class... Arguments>
void add_rich(RichParameterList& list, const ParameterSpec& spec, Arguments&&... value_and_words)
{
  if constexpr (std::is_constructible_v<Rich, Arguments..., bool>)
    list.addParam(Rich(std::forward<Arguments>(value_and_words)..., spec.advanced));
  else
    list.addParam(Rich(std::forward<Arguments>(value_and_words)...));
}

/// One row of the table as the parameter class that MeshLab's dialogs know.
inline void add_parameter(const ParameterSpec& spec, double diagonal, RichParameterList& list)
{
  const double value = default_value(spec);
  const QString name = spec.name, label = spec.label, tip = tooltip(spec);
  switch (spec.kind) {
    case Kind::boolean:
      add_rich<RichBool>(list, spec, name, value != 0, label, tip);
      break;
    case Kind::integer:
      add_rich<RichInt>(list, spec, name, int(value), label, tip);
      break;
    case Kind::real:
      add_rich<RichFloat>(list, spec, name, Scalarm(value), label, tip);
      break;
    case Kind::length:
      add_rich<RichLength>(list, spec, name, Scalarm(value), Scalarm(0), Scalarm(diagonal), label, tip);
      break;
    case Kind::save_file:
      add_rich<RichFile>(list, spec, name, "", (std::string("*") + spec.choices.front()).c_str(), label, tip);
      break;
    case Kind::choice: {
      QStringList choices;
      for (const char* choice : spec.choices) choices << choice;
      add_rich<RichEnum>(list, spec, name, int(value), choices, label, tip);
      break;
    }
  }
}

/// The dialog: percentages are of `diagonal`.
inline void add_parameters(const std::vector<ParameterSpec>& parameters, double diagonal, RichParameterList& list)
{
  // Without a mesh there is nothing to take a percentage of; an empty range would divide by zero.
  const double range = diagonal > 0 ? diagonal : 1;
  for (const ParameterSpec& spec : parameters) add_parameter(spec, range, list);
}

/// Reads every parameter from a host's list, through its getters, which all hosts name
/// alike. \throw ParameterError
template <class ParameterList>
Request read_request(const std::vector<ParameterSpec>& parameters, const ParameterList& list)
{
  Request request;
  for (const ParameterSpec& spec : parameters) {
    switch (spec.kind) {
      case Kind::boolean:
        store(spec, list.getBool(spec.name), request);
        break;
      case Kind::integer:
        store(spec, list.getInt(spec.name), request);
        break;
      case Kind::choice:
        store(spec, list.getEnum(spec.name), request);
        break;
      case Kind::real:
        store(spec, undo_float_rounding(list.getFloat(spec.name)), request);
        break;
      case Kind::length:
        store(spec, undo_float_rounding(list.getAbsPerc(spec.name)), request);
        break;
      case Kind::save_file:
        store_text(spec, list.getSaveFileName(spec.name).toStdString(), request);
        break;
    }
  }
  return request;
}

}  // namespace integral_invariant::filter
