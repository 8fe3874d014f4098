// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace test_support {

namespace {

void redirect(int descriptor, const char* path, int flags)
{
  const int file = open(path, flags, 0600);
  if (file >= 0) dup2(file, descriptor);
}

[[noreturn]] void become(std::vector<std::string> command, const std::string& folder, const TemporaryFolder& files)
{
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
  redirect(STDOUT_FILENO, (files / "out").c_str(), O_WRONLY | O_CREAT | O_TRUNC);
  redirect(STDERR_FILENO, (files / "err").c_str(), O_WRONLY | O_CREAT | O_TRUNC);
  if (folder.empty() || chdir(folder.c_str()) == 0) execvp(arguments[0], arguments.data());
  _exit(127);
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& command, const std::filesystem::path& folder)
{
  const TemporaryFolder files;
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start " + command[0]);
  if (child == 0) become(command, folder.string(), files);
  int status = 0;
  waitpid(child, &status, 0);
  ProgramResult result;
  result.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  result.output = read_text(files / "out") + read_text(files / "err");
  return result;
}

TemporaryFolder::TemporaryFolder()
{
  std::string pattern = (std::filesystem::temp_directory_path() / "ii_test_XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("cannot make a folder like " + pattern);
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string read_text(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void write_text(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::string environment(const char* name, const std::string& otherwise)
{
  const char* value = std::getenv(name);
  return value && *value ? value : otherwise;
}

}  // namespace test_support
