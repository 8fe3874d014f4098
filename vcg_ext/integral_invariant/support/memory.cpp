// SPDX-License-Identifier: GPL-3.0-or-later
// How much memory a run may take. The only file that asks the operating system.
#include "integral_invariant/support/memory.h"

#ifdef _WIN32
#include <windows.h>
#else
#include <unistd.h>
#endif

#include <cmath>
#include <cstdio>

#include "integral_invariant/error.h"

namespace integral_invariant {

namespace {

constexpr double mebibyte = 1024.0 * 1024.0;

double machine_memory()
{
#ifdef _WIN32
  MEMORYSTATUSEX status;
  status.dwLength = sizeof status;
  return GlobalMemoryStatusEx(&status) ? double(status.ullTotalPhys) : 4096 * mebibyte;
#else
  return double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
#endif
}

}  // namespace

std::size_t memory_limit_bytes(std::size_t limit_mb)
{
  return std::size_t(limit_mb > 0 ? double(limit_mb) * mebibyte : machine_memory() / 2);
}

std::string readable_bytes(double bytes)
{
  char text[64];
  if (bytes >= 1024 * mebibyte)
    std::snprintf(text, sizeof text, "%.1f GiB", bytes / (1024 * mebibyte));
  else
    std::snprintf(text, sizeof text, "%.0f MiB", std::ceil(bytes / mebibyte));
  return text;
}

void require_memory(double bytes, std::size_t limit_mb, const std::string& what, const std::string& advice)
{
  const double limit = double(memory_limit_bytes(limit_mb));
  if (bytes <= limit) return;
  throw MemoryError(what + " would need " + readable_bytes(bytes) + " of memory, more than the limit of " +
                    readable_bytes(limit) + ". " + advice + ", or raise memory_limit_mb.");
}

}  // namespace integral_invariant
