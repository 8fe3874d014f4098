// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/message_list.h"

#include <fstream>
#include <regex>
#include <stdexcept>

namespace test_support {

std::vector<std::string> listed_messages(const std::string& section)
{
  std::ifstream in(std::string(II_SOURCE_FOLDER) + "/docs/messages.md");
  if (!in) throw std::runtime_error("there is no docs/messages.md");
  std::vector<std::string> messages;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("## ", 0) == 0)
      inside = line.compare(3, section.size(), section) == 0;
    else if (inside && line.rfind("> ", 0) == 0)
      messages.push_back(line.substr(2));
  }
  return messages;
}

bool is_message(const std::string& message, const std::string& listed)
{
  static const std::regex special(R"([.*+?^${}()|[\]\\])"), difference("<[^>]*>");
  const std::string pattern = std::regex_replace(std::regex_replace(listed, special, R"(\$&)"), difference, "[^]+");
  return std::regex_match(message, std::regex(pattern));
}

}  // namespace test_support
