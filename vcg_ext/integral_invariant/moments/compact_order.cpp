// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: an order of places in which runs of consecutive ones are compact.
#include "integral_invariant/moments/compact_order.h"

#include <algorithm>

namespace integral_invariant {

namespace {

int longest_side(const PlacedItem* begin, const PlacedItem* end)
{
  float low[3], high[3];
  for (int i = 0; i < 3; ++i) low[i] = high[i] = begin->place[i];
  for (const PlacedItem* item = begin; item != end; ++item)
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], item->place[i]);
      high[i] = std::max(high[i], item->place[i]);
    }
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
  return axis;
}

/// `left`: the largest run·2^j under the number of items, or anything above it.
void split(PlacedItem* begin, PlacedItem* end, std::size_t left, std::size_t run)
{
  const std::size_t count = std::size_t(end - begin);
  if (count <= run) return;
  while (left >= count) left /= 2;
  const int axis = longest_side(begin, end);
  std::nth_element(begin, begin + left, end,
                   [axis](const PlacedItem& a, const PlacedItem& b) {
                     return a.place[axis] < b.place[axis] || (a.place[axis] == b.place[axis] && a.index < b.index);
                   });
  split(begin, begin + left, left / 2, run);
  split(begin + left, end, left, run);
}

}  // namespace

void order_compactly(std::vector<PlacedItem>& items, std::size_t run)
{
  std::size_t left = run;
  while (left < items.size()) left *= 2;
  split(items.data(), items.data() + items.size(), left, run);
}

}  // namespace integral_invariant
