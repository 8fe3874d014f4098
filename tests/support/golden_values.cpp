// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the golden values, or how far they are from those in a file: golden_values [FILE].
#include <cstdio>

#include "support/golden.h"

int main(int argc, char** argv)
{
  const test_support::GoldenValues values = test_support::golden_values();
  if (argc < 2) return std::fputs(test_support::golden_text(values).c_str(), stdout) < 0;
  std::string where = "all";
  const double difference =
      test_support::largest_golden_difference(test_support::read_golden_values(argv[1]), values, where);
  std::printf("largest relative difference %.2g (%s)\n", difference, where.c_str());
  return 0;
}
