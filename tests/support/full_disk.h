// SPDX-License-Identifier: GPL-3.0-or-later
// Disks without room, for tests of what is written.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace test_support {

/// While it lives, no file of this process can grow beyond that size, as on a full disk.
class SmallFiles {
 public:
  explicit SmallFiles(std::size_t bytes);
  ~SmallFiles();
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  std::size_t before_ = 0;
  void (*handler_)(int) = nullptr;
};

/// A file system of that size in memory, mounted on a folder until the end; that needs the rights of root.
class SmallDisk {
 public:
  SmallDisk(const std::filesystem::path& folder, std::size_t bytes);
  ~SmallDisk();
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  /// Why it could not be mounted; empty where it was.
  const std::string& unavailable() const { return unavailable_; }

 private:
  std::filesystem::path folder_;
  std::string unavailable_;
};

}  // namespace test_support
