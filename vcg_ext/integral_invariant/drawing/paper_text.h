// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: numbers as files have them.
#pragma once

#include <string>

namespace integral_invariant {

/// With a point and at most three decimals, whatever the host's locale: 0.35, -12, 7.001.
std::string decimal_text(double value);

}  // namespace integral_invariant
