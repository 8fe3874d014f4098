// SPDX-License-Identifier: GPL-3.0-or-later
// Surface engine: an order of places in which runs of consecutive ones are compact.
#include "integral_invariant/mesh/kd_sort.h"

#include <algorithm>
#include <array>

namespace integral_invariant {

namespace {

int longest_side(const SortItem* begin, const SortItem* end)
{
  float low[3], high[3];
  for (int i = 0; i < 3; ++i) low[i] = high[i] = begin->place[i];
  for (const SortItem* item = begin; item != end; ++item)
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], item->place[i]);
      high[i] = std::max(high[i], item->place[i]);
    }
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
  return axis;
}

/// Items [begin, end) that are to be split where `left` of them, or half as many and so on, are the larger share of
/// them.
struct Part {
  SortItem *begin, *end;
  std::size_t left;

  std::size_t count() const { return std::size_t(end - begin); }
};

/// The two shares, the second one empty where the part is a run.
std::array<Part, 2> halves(Part part, std::size_t run)
{
  if (part.count() <= run) return {part, {part.end, part.end, run}};
  while (part.left >= part.count()) part.left /= 2;
  const int axis = longest_side(part.begin, part.end);
  SortItem* middle = part.begin + part.left;
  std::nth_element(part.begin, middle, part.end, [axis](const SortItem& a, const SortItem& b) {
    return a.place[axis] < b.place[axis] || (a.place[axis] == b.place[axis] && a.index < b.index);
  });
  return {{{part.begin, middle, part.left / 2}, {middle, part.end, part.left}}};
}

void split(const Part& part, std::size_t run)
{
  if (part.count() <= run) return;
  for (const Part& half : halves(part, run)) split(half, run);
}

}  // namespace

void kd_sort(std::vector<SortItem>& items, std::size_t run, Execution& execution)
{
  // A few milliseconds' work each, and what a worker orders alone: nobody who wants to stop waits for more.
  const std::size_t stretch = run * longest_segment;
  constexpr std::size_t largest_share = 65536;
  std::vector<Part> parts;
  for (std::size_t begin = 0; begin < items.size(); begin += stretch)
    parts.push_back({items.data() + begin, items.data() + std::min(begin + stretch, items.size()), stretch});
  for (std::size_t share = std::min(stretch, items.size()); share > largest_share; share = (share + 1) / 2) {
    std::vector<Part> shares(2 * parts.size());
    parallel_step(parts.size(), 1, execution, [&](std::size_t begin, std::size_t end, int) {
      for (std::size_t i = begin; i < end; ++i) {
        const std::array<Part, 2> pair = halves(parts[i], run);
        std::copy(pair.begin(), pair.end(), shares.begin() + std::ptrdiff_t(2 * i));
      }
    });
    parts.swap(shares);
  }
  parallel_step(parts.size(), 1, execution, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) split(parts[i], run);
  });
}

}  // namespace integral_invariant
