// SPDX-License-Identifier: GPL-3.0-or-later
// Command line: prints a filter script with every parameter, or the parameters themselves.
#include <iostream>
#include <string>
#include <vector>

#include "filter_script.h"

namespace {

constexpr const char* usage =
    "Usage: write_filter_script [NAME=VALUE ...]   print a MeshLab filter script (.mlx) with every parameter\n"
    "       write_filter_script --list             print NAME=DEFAULT of every parameter\n"
    "       write_filter_script --describe         print the parameters as a Markdown table\n";

std::string answer(const std::vector<std::string>& arguments)
{
  using namespace integral_invariant::filter;
  if (arguments.size() == 1 && arguments[0] == "--help") return usage;
  if (arguments.size() == 1 && arguments[0] == "--list") return parameter_defaults();
  if (arguments.size() == 1 && arguments[0] == "--describe") return parameter_documentation();
  Request request;
  for (const std::string& assignment : arguments) store_assignment(assignment, request);
  return filter_script(request);
}

}  // namespace

int main(int argc, char** argv)
{
  try {
    std::cout << answer({argv + 1, argv + argc});
    return std::cout.flush() ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "write_filter_script: " << error.what() << '\n';
    return 2;
  }
}
