// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of the moment engine.
#include "integral_invariant/moments/engine.h"

#include "integral_invariant/moments/fft/fft_engine.h"
#include "integral_invariant/moments/surface/surface_engine.h"

namespace integral_invariant {

std::unique_ptr<MomentEngine> make_moment_engine(const Surface& surface, const Parameters& parameters,
                                                 Execution& execution)
{
  if (parameters.engine == EngineKind::surface_integral) return make_surface_engine(surface, parameters, execution);
  return make_fft_engine(surface, parameters);
}

}  // namespace integral_invariant
