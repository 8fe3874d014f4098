// SPDX-License-Identifier: GPL-3.0-or-later
// Command line: prints a filter script with every parameter, or the parameters themselves.
#include <iostream>
#include <string>
#include <vector>

#include "filter_script.h"
#include "registry.h"

namespace {

constexpr const char* usage =
    "Usage: write_filter_script [--filter FILTER] [NAME=VALUE ...]   print a MeshLab filter script (.mlx) with every\n"
    "                                                                parameter of the filter\n"
    "       write_filter_script [--filter FILTER] --list             print NAME=DEFAULT of every parameter\n"
    "       write_filter_script [--filter FILTER] --describe         print the parameters as a Markdown table\n"
    "       write_filter_script --filters                            print the names that FILTER can be\n";

using namespace integral_invariant::filter;

std::string filter_names()
{
  std::string text;
  for (const Filter* filter : all_filters()) text += std::string(filter->python_name) + "\t" + filter->name + "\n";
  return text;
}

std::string answer(std::vector<std::string> arguments)
{
  const Filter* filter = &curvature_filter();
  if (arguments.size() >= 2 && arguments[0] == "--filter") {
    filter = &find_filter(arguments[1]);
    arguments.erase(arguments.begin(), arguments.begin() + 2);
  }
  if (arguments.size() == 1 && arguments[0] == "--filters") return filter_names();
  if (arguments.size() == 1 && arguments[0] == "--help") return usage;
  if (arguments.size() == 1 && arguments[0] == "--list") return parameter_defaults(*filter);
  if (arguments.size() == 1 && arguments[0] == "--describe") return parameter_documentation(*filter);
  Request request;
  for (const std::string& assignment : arguments) store_assignment(*filter, assignment, request);
  return filter_script(*filter, request);
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
