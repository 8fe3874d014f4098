// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace accuracy {

/// accuracy families [--seed N] [--half tuning|report] [--models FOLDER] [--cells TEXT] [--csv FILE]
///                   [--references FILE]
///
/// Compares the default settings with the best constant radius of each cell and the published method, in a table by
/// family on the standard output. The tuning half writes its rows to the CSV file, and keeps
/// what the constant radii and the published method have said in the file of references, so that only the default
/// settings run the next time. The report half has other shapes and other
/// draws; what it says is only shown by family, so that nothing can be tuned to its cells. \throw std::invalid_argument
void run_families(const std::vector<std::string>& argv);

}  // namespace accuracy
