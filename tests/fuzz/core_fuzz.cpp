// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzzing: any mesh with any parameters through the whole pipeline. Either it is refused in words, or cancelled when
// asked to, or every value is finite and in its range, whatever the number of threads.
#include "fuzz/invariants.h"
#include "fuzz/read_mesh.h"
#include "fuzz/read_parameters.h"
#include "integral_invariant/curvature.h"
#include "integral_invariant/error.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace integral_invariant;
  fuzz::ByteReader bytes(data, size);
  Parameters parameters = fuzz::read_parameters(bytes);
  const std::uint32_t twist = bytes.below(8);
  const TriangleMesh mesh = fuzz::read_mesh(bytes);
  int calls_left = twist == 1 ? int(bytes.below(8)) : 1 << 30;
  try {
    const Result result = compute_curvature(mesh, parameters, [&](int percent, const char* stage) {
      fuzz::require(percent >= 0 && percent <= 100 && *stage, "progress is a percentage and a stage");
      return calls_left-- > 0;
    });
    fuzz::require_sound(result, mesh.positions.size());
    if (twist != 2) return 0;
    parameters.threads = parameters.threads == 1 ? 3 : 1;
    fuzz::require_equal(result, compute_curvature(mesh, parameters));
  } catch (const InputError& error) {
    fuzz::require_sentence(error);
  } catch (const Cancelled&) {
    fuzz::require(calls_left < 0, "only the callback cancels");
  }
  return 0;
}
