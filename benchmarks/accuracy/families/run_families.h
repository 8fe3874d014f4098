// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace accuracy {

/// accuracy families [--seed N] [--half tuning|report] [--models FOLDER] [--cells TEXT] [--csv FILE]
///                   [--references FILE]
///
/// Compares the default settings with the best constant radius of each cell and the published method, in a table by
/// family on the standard output. The tuning half writes its rows to the CSV file. The report half
/// has other shapes and other draws, and the default's results on it are only shown by family, so that nothing can be
/// tuned to its cells. The results of the constant radii and the published method are kept in the file of references;
/// with the same seed only the default settings run the next time. \throw std::invalid_argument
void run_families(const std::vector<std::string>& argv);

}  // namespace accuracy
