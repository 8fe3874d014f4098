// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzzing: a filter script back from its XML.
#pragma once

#include <string>
#include <vector>

namespace fuzz {

struct ReadScript {
  std::string filter;
  std::vector<std::string> assignments;  ///< "name=value"
};

/// Holds the text to the rules of XML 1.0 that a reader would refuse it for: the characters that are permitted, quotes,
/// entities; line breaks and tabs within a value are read as spaces. Ends the program where one is broken.
ReadScript read_script(const std::string& xml);

}  // namespace fuzz
