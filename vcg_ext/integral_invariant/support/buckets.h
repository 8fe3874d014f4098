// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "integral_invariant/support/execution.h"

namespace integral_invariant {

/// Items by a key of few values, those of a key side by side.
template <class Item>
struct Buckets {
  std::vector<Item> items;
  std::vector<std::uint32_t> ends;  ///< a bucket begins where the one before it ends

  std::size_t count() const { return ends.size(); }
  const Item* begin(std::size_t key) const { return items.data() + (key == 0 ? 0 : ends[key - 1]); }
  const Item* end(std::size_t key) const { return items.data() + ends[key]; }
  Item* begin(std::size_t key) { return items.data() + (key == 0 ? 0 : ends[key - 1]); }
  Item* end(std::size_t key) { return items.data() + ends[key]; }
};

/// What `give(i, put)` hands to put(key, item), for all i in [0, count) and keys in [0, keys); a bucket's items in the
/// order in which they came. Asked twice for each i, it must say the same. Cost O(count + keys), on the calling thread.
/// \throw Cancelled
template <class Item, class Give>
Buckets<Item> in_buckets(std::size_t count, std::size_t keys, Execution& execution, const Give& give)
{
  std::vector<std::uint32_t> next;
  resize_in_steps(next, keys + 1, execution);
  for_each_in_order(count, execution,
                    [&](std::size_t i) { give(i, [&](std::size_t key, const Item&) { ++next[key + 1]; }); });
  std::partial_sum(next.begin(), next.end(), next.begin());
  execution.check();
  Buckets<Item> buckets;
  resize_in_steps(buckets.items, next.back(), execution);
  for_each_in_order(count, execution, [&](std::size_t i) {
    give(i, [&](std::size_t key, const Item& item) { buckets.items[next[key]++] = item; });
  });
  // Filled, a bucket's start has moved to its end.
  next.pop_back();
  buckets.ends = std::move(next);
  return buckets;
}

}  // namespace integral_invariant
