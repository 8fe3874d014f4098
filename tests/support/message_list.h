// SPDX-License-Identifier: GPL-3.0-or-later
// The list of all messages, docs/messages.md, as tests read it.
#pragma once

#include <string>
#include <vector>

namespace test_support {

/// The messages of the sections whose headings begin with `section`, as they stand there: <...> is what differs.
std::vector<std::string> listed_messages(const std::string& section);

/// `message` is `listed`, with any text in the place of each <...>.
bool is_message(const std::string& message, const std::string& listed);

}  // namespace test_support
