// SPDX-License-Identifier: GPL-3.0-or-later
// accuracy peers|ours|cost [--models FOLDER] [--cells TEXT] [--part I/N] > table.csv
// accuracy families [--seed N] [--half tuning|report] [--models FOLDER] [--cells TEXT] [--csv FILE]
//                   [--references FILE]
// accuracy family_peers [--seed N] [--cells TEXT] [--peers FILE]
// accuracy scans FOLDER
// accuracy frame SEED FILE...
// accuracy creases FILE...
//
// cell_modes.h, families/run_families.h, families/family_peers.h, cross_scan.h, frame.h and crease_quality.h say what
// each of these does.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "cell_modes.h"
#include "crease_quality.h"
#include "cross_scan.h"
#include "families/family_peers.h"
#include "families/run_families.h"
#include "frame.h"

namespace {

using namespace accuracy;

void run(const std::vector<std::string>& argv)
{
  const std::string mode = argv.size() > 1 ? argv[1] : "";
  const std::vector<std::string> operands(argv.begin() + std::min<std::ptrdiff_t>(2, argv.end() - argv.begin()),
                                          argv.end());
#ifdef II_WITH_VCG
  if (mode == "families") return run_families(argv);
  if (mode == "family_peers") return run_family_peers(argv);
#endif
  if (mode == "scans" && operands.size() == 1) return print_cross_scan_scores(operands[0]);
  if (mode == "frame" && operands.size() > 1)
    return print_frame_dependence({operands.begin() + 1, operands.end()}, std::uint32_t(std::stoul(operands[0])));
  if (mode == "creases" && !operands.empty()) return print_crease_quality(operands);
  run_cells(argv);
}

}  // namespace

int main(int argc, char** argv)
try {
  run({argv, argv + argc});
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return EXIT_FAILURE;
}
