// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a fuzz target on files, without a fuzzer: run_corpus FOLDER-OR-FILE...
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "fuzz/invariants.h"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_below(const char* name)
{
  if (fs::is_regular_file(name)) return {name};
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(name)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int argc, char** argv)
{
  std::size_t count = 0;
  for (int i = 1; i < argc; ++i)
    for (const fs::path& file : files_below(argv[i])) {
      std::ifstream stream(file, std::ios::binary);
      const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
      std::fprintf(stderr, "%s\n", file.filename().c_str());  // the last one named is the one that failed
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      ++count;
    }
  std::printf("%zu inputs\n", count);
  return count > 0 ? 0 : 1;
}
