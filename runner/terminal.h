// SPDX-License-Identifier: GPL-3.0-or-later
// What the user sees: progress on stderr where that is a terminal, logs on stdout.
#pragma once

#include <string>

namespace runner {

/// Applies to all that follows.
void set_quiet(bool quiet);

/// MeshLab's callback: one line that is written over; never asks to stop.
bool show_progress(int percent, const char* text);
void clear_progress();

void say(const std::string& line);
void complain(const std::string& sentence);

}  // namespace runner
