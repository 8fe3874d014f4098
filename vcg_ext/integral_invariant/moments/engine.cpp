// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of the moment engine.
#include "integral_invariant/moments/engine.h"

#include "integral_invariant/support/error.h"

namespace integral_invariant {

std::unique_ptr<MomentEngine> make_moment_engine(const Surface&, const Parameters&)
{
  throw InputError("no engine yet");
}

}  // namespace integral_invariant
