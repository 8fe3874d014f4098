// SPDX-License-Identifier: GPL-3.0-or-later
// Runs whose results are kept in tests/golden/values.txt and must be the same everywhere.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace test_support {

/// "mesh engine radius quantity" to mean, root mean square, and the values that 5, 50 and 95 % do not exceed.
using GoldenValues = std::map<std::string, std::vector<double>>;

/// Of all runs: closed, open, sharp and noisy shapes, both engines where they can, the default and the published
/// method.
GoldenValues golden_values();

std::string golden_text(const GoldenValues& values);
/// \throw std::runtime_error where the file cannot be read
GoldenValues read_golden_values(const std::string& file);

/// The largest difference of two numbers under the same name, relative to the root mean square of both; infinite where
/// the names differ. `where` receives the name.
double largest_golden_difference(const GoldenValues& a, const GoldenValues& b, std::string& where);

}  // namespace test_support
