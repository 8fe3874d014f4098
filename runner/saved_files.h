// SPDX-License-Identifier: GPL-3.0-or-later
// Files that MeshLab writes for the runner appear whole or not at all.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace runner {

/// A file cannot be written; what() is the system's reason.
class NotWritten : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file, and those that its format keeps beside it, are made in a folder of their own next to where they belong and
/// moved from there when they are complete. MeshLab's exporters do not notice a full disk; this asks the disk
/// afterwards.
class SavedFiles {
 public:
  /// \throw NotWritten where the folder of `file` takes no files
  explicit SavedFiles(const std::string& file);
  ~SavedFiles();
  SavedFiles(const SavedFiles&) = delete;
  SavedFiles& operator=(const SavedFiles&) = delete;

  /// Where the exporter is to write.
  std::filesystem::path file() const { return folder_ / target_.filename(); }
  /// \throw NotWritten where no file was made or the disk is full
  void move_into_place() const;

 private:
  std::filesystem::path target_, folder_;
};

}  // namespace runner
