// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzzing: what must hold whatever the input.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

#include "integral_invariant/result.h"

/// One input, whatever its bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

/// Ends the program with the sentence where `holds` is false: the fuzzer keeps the input then.
inline void require(bool holds, const char* sentence)
{
  if (holds) return;
  std::fprintf(stderr, "invariant broken: %s\n", sentence);
  std::abort();
}

void require_finite(const std::vector<double>& values, const char* sentence);
void require_finite(const std::vector<float>& values, const char* sentence);

/// All that result.h promises for a mesh of that many vertices.
void require_sound(const integral_invariant::Result& result, std::size_t vertices);

/// The same to the bit.
void require_equal(const integral_invariant::Result& a, const integral_invariant::Result& b);

/// A refusal must say something.
void require_sentence(const std::exception& error);

}  // namespace fuzz
