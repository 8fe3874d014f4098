// SPDX-License-Identifier: GPL-3.0-or-later
// Fixed decimals by whole numbers: printf and streams ask the locale for the point.
#include "integral_invariant/drawing/paper_text.h"

#include <cmath>

namespace integral_invariant {

std::string decimal_text(double value)
{
  constexpr long long thousand = 1000;
  const long long thousandths = std::llround(value * thousand);
  const long long size = thousandths < 0 ? -thousandths : thousandths;
  std::string text = (thousandths < 0 ? "-" : "") + std::to_string(size / thousand);
  if (size % thousand == 0) return text;
  std::string decimals = std::to_string(thousand + size % thousand).substr(1);
  while (decimals.back() == '0') decimals.pop_back();
  return text + "." + decimals;
}

}  // namespace integral_invariant
