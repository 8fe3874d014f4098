// SPDX-License-Identifier: GPL-3.0-or-later
// MeshLab's document and plugins without its window. session.cpp is the only file here that includes MeshLab.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace runner {

/// One at a time: MeshLab keeps its plugins in a global manager. Every failure is a Failure with its exit status.
class Session {
 public:
  /// `program_name` must outlive it: Qt keeps it. The program's options are not Qt's, so Qt does not see them.
  explicit Session(char* program_name);
  ~Session();

  static std::string meshlab_version();

  /// MeshLab's own plugins; those that do not load are named in the log and left out, as MeshLab does.
  void load_own_plugins(const std::string& folder);
  void load_plugin(const std::string& file);
  std::vector<std::string> filter_names() const;

  void load_mesh(const std::string& file);
  /// Checks the whole script before the first filter runs.
  void run_script(const std::string& file);
  void save_current_mesh(const std::string& file, bool ascii);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace runner
