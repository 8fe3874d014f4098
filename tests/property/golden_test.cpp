// SPDX-License-Identifier: GPL-3.0-or-later
// The same answer everywhere: results kept in tests/golden/values.txt. `scripts/golden --update` writes them anew.
#include "support/golden.h"

#include <gtest/gtest.h>

TEST(Golden, ValuesAreThoseOnFileWithAnyCompiler)
{
  // g++ 12 and clang++ 14 give the same bits (scripts/golden): no instruction that fuses operations is used by either.
  // Room for mathematical libraries that round a last bit otherwise.
  constexpr double tolerance = 1e-9;
  std::string where;
  EXPECT_LT(test_support::largest_golden_difference(
                test_support::read_golden_values(II_SOURCE_FOLDER "/tests/golden/values.txt"),
                test_support::golden_values(), where),
            tolerance)
      << where;
}
