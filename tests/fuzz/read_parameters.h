// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzzing: bytes as parameters.
#pragma once

#include "fuzz/byte_reader.h"
#include "integral_invariant/parameters.h"

namespace fuzz {

/// Every field as it is by default, within its range, or anything at all. Memory is limited to a few MiB, and what only
/// takes time (iterations, passes, cells) is either small or out of its range.
integral_invariant::Parameters read_parameters(ByteReader& bytes);

/// What read_parameters() sees to for a request made otherwise: memory and time.
void keep_small(integral_invariant::Parameters& parameters);

}  // namespace fuzz
