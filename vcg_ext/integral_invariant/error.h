// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace integral_invariant {

/// The input cannot be worked with; what() says what is wrong, where, and what to do about it.
class InputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A parameter is out of its range or contradicts another; what() names it.
class ParameterError : public InputError {
  using InputError::InputError;
};

/// The run would need more memory than it may take; what() says how much and which parameter to change.
class MemoryError : public InputError {
  using InputError::InputError;
};

/// The callback asked to stop.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("The computation was cancelled; the mesh is unchanged.") {}
};

}  // namespace integral_invariant
