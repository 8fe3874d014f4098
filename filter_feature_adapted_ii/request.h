// SPDX-License-Identifier: GPL-3.0-or-later
// Host layer, without any host: what a filter is asked.
#pragma once

#include <any>
#include <map>
#include <string>
#include <typeindex>

#include "quality.h"

namespace integral_invariant::filter {

/// The parameters of one run of a filter, in parts: integral_invariant::Parameters, OutputOptions, and whatever structs
/// the filter's own parameters write. A part that nothing was written to has its defaults.
class Request {
 public:
  template <class Part>
  Part& part()
  {
    std::any& slot = parts_[typeid(Part)];
    if (!slot.has_value()) slot.emplace<Part>();
    return *std::any_cast<Part>(&slot);
  }
  template <class Part>
  const Part& part() const
  {
    static const Part defaults{};
    const auto found = parts_.find(typeid(Part));
    return found == parts_.end() ? defaults : *std::any_cast<Part>(&found->second);
  }

 private:
  std::map<std::type_index, std::any> parts_;
};

/// What is done with what was computed.
struct OutputOptions {
  Quantity quality = Quantity::mean;
  bool colorize = true;
  double color_percentile = 95;  ///< how many per cent of the vertices lie inside the colour range, in [50, 100]
  std::string export_file;       ///< PLY with every output; empty: none
};

}  // namespace integral_invariant::filter
