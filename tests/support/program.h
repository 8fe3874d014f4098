// SPDX-License-Identifier: GPL-3.0-or-later
// Running other programs and keeping their files in a folder that goes away.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace test_support {

struct ProgramResult {
  int status = 0;      ///< exit status; 128 + n when signal n ended it
  std::string output;  ///< what it wrote on stdout and stderr, in that order
};

/// Runs a program with these arguments, no shell in between, in `folder` (the current one when empty).
ProgramResult run_program(const std::vector<std::string>& command, const std::filesystem::path& folder = {});

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::string read_text(const std::string& path);
void write_text(const std::string& path, const std::string& text);

/// The value of an environment variable, or `otherwise` where it is not set or empty.
std::string environment(const char* name, const std::string& otherwise);

}  // namespace test_support
