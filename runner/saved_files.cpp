// SPDX-License-Identifier: GPL-3.0-or-later
#include "saved_files.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>
#include <vector>

#include <unistd.h>

namespace runner {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::error_code& error) { throw NotWritten(error.message()); }

/// A write that found no room has filled what there was, so this finds none either.
void require_room(const fs::path& folder)
{
  const std::vector<char> some(65536);  // more than any exporter's or library's buffer
  const fs::path name = folder / "room";
  std::FILE* file = std::fopen(name.c_str(), "wb");
  if (!file) fail({errno, std::generic_category()});
  const bool taken = std::fwrite(some.data(), 1, some.size(), file) == some.size() && std::fflush(file) == 0 &&
                     ::fsync(::fileno(file)) == 0;
  const int reason = errno;
  const bool closed = std::fclose(file) == 0;
  if (!taken) fail({reason, std::generic_category()});
  if (!closed) fail({errno, std::generic_category()});
  fs::remove(name);
}

}  // namespace

SavedFiles::SavedFiles(const std::string& file) : target_(fs::absolute(file))
{
  if (fs::is_directory(target_)) throw NotWritten("it is a folder");
  std::string name = (target_.parent_path() / ".meshlab-XXXXXX").string();
  if (!::mkdtemp(name.data())) fail({errno, std::generic_category()});
  folder_ = name;
}

SavedFiles::~SavedFiles()
{
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void SavedFiles::move_into_place() const
{
  if (!fs::is_regular_file(file())) throw NotWritten("MeshLab made no file");
  require_room(folder_);
  // The file itself last: what it refers to is there before it.
  std::vector<fs::path> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
    if (entry.path() != file()) names.push_back(entry.path().filename());
  names.push_back(target_.filename());
  std::error_code error;
  for (const fs::path& name : names) {
    fs::rename(folder_ / name, target_.parent_path() / name, error);
    if (error) fail(error);
  }
}

}  // namespace runner
