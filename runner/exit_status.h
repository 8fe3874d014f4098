// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace runner {

/// What went wrong, as the program's exit status. Documented in docs/hosts.md and by --help.
enum class ExitStatus {
  done = 0,
  filter_failed = 1,
  bad_command_line = 2,
  plugin_not_loaded = 3,
  mesh_not_read = 4,
  script_not_usable = 5,
  output_not_written = 6,
};

/// A sentence for the user, and the status that the program ends with.
class Failure : public std::runtime_error {
 public:
  Failure(ExitStatus status, const std::string& sentence) : std::runtime_error(sentence), status_(status) {}
  ExitStatus status() const { return status_; }

 private:
  ExitStatus status_;
};

}  // namespace runner
