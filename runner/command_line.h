// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace runner {

struct CommandLine {
  std::vector<std::string> plugins;  ///< loaded after MeshLab's own
  std::string plugin_folder;         ///< of MeshLab's own; empty: beside its library
  std::vector<std::string> inputs;
  std::vector<std::string> scripts;
  std::string output;  ///< empty: nothing is saved
  bool ascii = false;
  bool quiet = false;
  bool list_filters = false;
  bool help = false;
  bool version = false;
};

/// \throw Failure with ExitStatus::bad_command_line
CommandLine parse_command_line(const std::vector<std::string>& arguments);

std::string help_text();

}  // namespace runner
