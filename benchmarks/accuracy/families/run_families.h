// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace accuracy {

/// accuracy families [--seed N] [--half tuning|report] [--models FOLDER] [--cells TEXT] [--csv FILE]
///
/// The default settings against the best constant radius of each cell and the published method; a table by family on
/// the standard output. The tuning half writes its rows to FILE. The report half has other shapes and other draws; what
/// it says is only shown by family, so that nothing can be tuned to its cells. \throw std::invalid_argument
void run_families(int argc, char** argv);

}  // namespace accuracy
