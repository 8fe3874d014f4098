// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace integral_invariant::filter {

/// Sequences of UTF-8, as far as lead and continuation bytes tell: what a script, which is XML, can hold.
inline bool is_utf8(const std::string& text)
{
  std::size_t awaited = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool continues = (byte & 0xc0) == 0x80;
    if (continues != (awaited > 0)) return false;
    if (continues)
      --awaited;
    else if (byte >= 0xf8)
      return false;
    else
      awaited = byte >= 0xf0 ? 3 : byte >= 0xe0 ? 2 : byte >= 0xc0 ? 1 : 0;
  }
  return awaited == 0;
}

}  // namespace integral_invariant::filter
