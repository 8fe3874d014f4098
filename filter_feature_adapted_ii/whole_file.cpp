// SPDX-License-Identifier: GPL-3.0-or-later
// Every call that may lose bytes is checked: the writes, what the library has kept back, what the system has kept back
// (a disk over a network, or one with quotas, reports a lack of room only then), and the close.
#include "whole_file.h"

#include <cerrno>
#include <random>
#include <system_error>

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace integral_invariant::filter {

namespace {

namespace fs = std::filesystem;

constexpr const char* other_folder = "Choose a folder that exists and that you may write to.";

const char* advice(const std::error_code& error)
{
  if (error == std::errc::filename_too_long) return "Choose a shorter name, or a folder less deep.";
  const bool no_room =
      error == std::errc::no_space_on_device || error == std::errc::file_too_large || error.value() == EDQUOT;
  return no_room ? "Make room there, or choose a folder on another disk." : other_folder;
}

[[noreturn]] void fail(const std::error_code& error) { throw FileError(error.message() + ". " + advice(error)); }

[[noreturn]] void fail_with_errno() { fail({errno, std::generic_category()}); }

/// A file that may not be written is not replaced either, though its folder would allow it.
bool is_protected(const fs::path& file)
{
#if __has_include(<unistd.h>)
  return ::access(file.c_str(), W_OK) != 0;
#else
  return (fs::status(file).permissions() & fs::perms::owner_write) == fs::perms::none;
#endif
}

/// The file that is to be replaced or made, at the end of any links.
fs::path checked_target(const std::string& path)
{
  std::error_code error;
  const fs::path target = fs::weakly_canonical(fs::absolute(fs::u8path(path)), error);
  if (error) fail(error);
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) throw FileError("it is a folder. Name a file, for example one in that folder.");
  if (fs::exists(status) && !fs::is_regular_file(status)) throw FileError("it is a device or a pipe. Name a file.");
  if (status.type() == fs::file_type::none) fail(error);
  if (fs::exists(status) && is_protected(target)) fail(std::make_error_code(std::errc::permission_denied));
  return target;
}

/// A new, empty file in that folder, under a name that no other run uses.
std::FILE* create_in(const fs::path& folder, fs::path& name)
{
  constexpr int attempts = 100;
  std::random_device random;
  for (int i = 0; i < attempts; ++i) {
    name = folder / (".curvature-" + std::to_string(random()) + ".part");
    if (std::FILE* file = std::fopen(name.string().c_str(), "wbx")) return file;
    if (errno != EEXIST) break;
  }
  fail_with_errno();
}

bool reaches_the_disk(std::FILE* file)
{
  if (std::fflush(file) != 0) return false;
#if __has_include(<unistd.h>)
  // EINVAL: a file system that keeps nothing back.
  return ::fsync(::fileno(file)) == 0 || errno == EINVAL;
#else
  return true;
#endif
}

}  // namespace

WholeFile::WholeFile(const std::string& path) : target_(checked_target(path))
{
  file_ = create_in(target_.parent_path(), temporary_);
}

WholeFile::~WholeFile()
{
  if (file_) std::fclose(file_);
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void WholeFile::write(const void* data, std::size_t bytes)
{
  if (std::fwrite(data, 1, bytes, file_) != bytes) fail_with_errno();
}

void WholeFile::close()
{
  std::FILE* file = file_;
  file_ = nullptr;
  const bool complete = reaches_the_disk(file);
  const int reason = errno;
  if (std::fclose(file) != 0) fail_with_errno();
  errno = reason;
  if (!complete) fail_with_errno();
}

std::string WholeFile::commit()
{
  close();
  std::error_code error;
  const fs::file_status older = fs::status(target_, error);
  if (fs::exists(older)) fs::permissions(temporary_, older.permissions(), error);
  fs::rename(temporary_, target_, error);
  if (error) fail(error);
  temporary_.clear();
  return target_.u8string();
}

}  // namespace integral_invariant::filter
