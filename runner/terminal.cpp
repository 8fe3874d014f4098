// SPDX-License-Identifier: GPL-3.0-or-later
#include "terminal.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace runner {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto redraw_interval = std::chrono::milliseconds(50);  // some filters report for every vertex

bool is_quiet = false;
bool progress_is_shown = false;

/// Filters may end their text with a line break or with the percentage, which is shown in front anyway.
std::string without_percentage(std::string text)
{
  const auto cut_last = [&text](const char* characters) {
    const std::size_t last = text.find_last_not_of(characters);
    text.erase(last == std::string::npos ? 0 : last + 1);
  };
  cut_last(" \n\r");
  if (!text.empty() && text.back() == '%') {
    cut_last("%0123456789");
    cut_last(": ");
  }
  return text;
}

}  // namespace

void set_quiet(bool quiet) { is_quiet = quiet; }

bool show_progress(int percent, const char* text)
{
  static const bool is_terminal = isatty(STDERR_FILENO);
  static Clock::time_point last{};
  if (is_quiet || !is_terminal || Clock::now() - last < redraw_interval) return true;
  last = Clock::now();
  std::fprintf(stderr, "\r\033[K%3d %%  %.70s", percent, without_percentage(text ? text : "").c_str());
  std::fflush(stderr);
  progress_is_shown = true;
  return true;
}

void clear_progress()
{
  if (progress_is_shown) std::fputs("\r\033[K", stderr);
  progress_is_shown = false;
}

void say(const std::string& line)
{
  if (is_quiet) return;
  clear_progress();
  std::printf("%s\n", line.c_str());
}

void complain(const std::string& sentence)
{
  clear_progress();
  std::fflush(stdout);
  std::fprintf(stderr, "meshlab_script_runner: %s\n", sentence.c_str());
}

}  // namespace runner
