// SPDX-License-Identifier: GPL-3.0-or-later
// Files that appear whole or not at all, whatever happens while they are written.
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace integral_invariant::filter {

/// A file cannot be written; what() says why and what to do, without the file's name.
class FileError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Written under a name of its own in the folder of the target, which takes the target's name only when every byte is
/// on the disk. Until then an older file stays as it was; without commit() nothing is left behind.
class WholeFile {
 public:
  /// `path` is UTF-8. A link is followed to the file that it names. \throw FileError where no file of that name can be
  explicit WholeFile(const std::string& path);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// \throw FileError unless all bytes are taken
  void write(const void* data, std::size_t bytes);
  /// The last call. \return the absolute path. \throw FileError
  std::string commit();

 private:
  void close();

  std::filesystem::path target_, temporary_;
  std::FILE* file_ = nullptr;
};

}  // namespace integral_invariant::filter
