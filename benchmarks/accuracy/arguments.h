// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of one mode of the benchmark: options "--name value".
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace accuracy {

class Arguments {
 public:
  /// \param argv the program, the mode, then the options. \param names those that the mode knows, with their dashes.
  /// \throw std::invalid_argument with `usage` where an option is unknown or has no value
  Arguments(const std::vector<std::string>& argv, const std::vector<std::string>& names, const std::string& usage);

  /// The value of an option, or `fallback` where it was not given.
  std::string text(const std::string& name, const std::string& fallback = "") const;
  std::uint32_t number(const std::string& name, std::uint32_t fallback) const;

 private:
  std::map<std::string, std::string> values_;
};

}  // namespace accuracy
