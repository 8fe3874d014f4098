// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices in order along a space-filling curve. In: positions. Out: those that count, with their cells.
#include "integral_invariant/mesh/hilbert_sort.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "integral_invariant/mesh.h"
#include "integral_invariant/support/buckets.h"

namespace integral_invariant {

std::vector<CurveCell> hilbert_sort(const HilbertCurve& curve, const std::vector<Vec3>& positions,
                                    const std::function<bool(std::size_t vertex)>& counts, Execution& execution)
{
  // Parts of the curve first, so that workers can sort them, and none for long.
  constexpr int part_bits = 12, bits_within = 3 * HilbertCurve::bits - part_bits;
  const std::vector<std::uint64_t> cells = curve.indices(positions, execution);
  Buckets<CurveCell> parts = in_buckets<CurveCell>(
      positions.size(), std::size_t(1) << part_bits, execution, [&](std::size_t v, const auto& put) {
        if (counts(v)) put(cells[v] >> bits_within, CurveCell{cells[v], std::uint32_t(v)});
      });
  const auto less = [&](const CurveCell& a, const CurveCell& b) {
    return a.cell != b.cell ? a.cell < b.cell : precedes(a.vertex, b.vertex, positions);
  };
  parallel_step(parts.count(), 16, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t part = begin; part < end; ++part)
      // A mesh that was in this order before is so still, but for rounding.
      if (!std::is_sorted(parts.begin(part), parts.end(part), less))
        std::sort(parts.begin(part), parts.end(part), less);
  });
  return std::move(parts.items);
}

}  // namespace integral_invariant
