// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/full_disk.h"

#include <cerrno>
#include <csignal>
#include <cstring>

#include <sys/mount.h>
#include <sys/resource.h>

namespace test_support {

namespace {

/// \return the limit before
rlim_t set_largest_file(rlim_t bytes)
{
  rlimit limit{};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  const rlim_t before = limit.rlim_cur;
  limit.rlim_cur = bytes;
  ::setrlimit(RLIMIT_FSIZE, &limit);
  return before;
}

}  // namespace

// The signal that comes with the refusal would end the process.
SmallFiles::SmallFiles(std::size_t bytes) : before_(set_largest_file(bytes)), handler_(std::signal(SIGXFSZ, SIG_IGN)) {}

SmallFiles::~SmallFiles()
{
  set_largest_file(before_);
  std::signal(SIGXFSZ, handler_);
}

SmallDisk::SmallDisk(const std::filesystem::path& folder, std::size_t bytes) : folder_(folder)
{
  const std::string options = "size=" + std::to_string(bytes);
  if (::mount("tmpfs", folder.c_str(), "tmpfs", 0, options.c_str()) != 0)
    unavailable_ = std::string("a small disk cannot be mounted: ") + std::strerror(errno);
}

SmallDisk::~SmallDisk()
{
  if (unavailable_.empty()) ::umount(folder_.c_str());
}

}  // namespace test_support
