// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/run_families.h"

#include <cstdio>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "arguments.h"
#include "families/constant_radius.h"
#include "families/families.h"
#include "families/family_report.h"
#include "families/reference_results.h"
#include "own_method.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

constexpr const char* usage =
    "usage: accuracy families [--seed N] [--half tuning|report] [--models FOLDER] [--cells TEXT] [--csv FILE]\n"
    "       [--references FILE]\n"
    "TEXT is part of family/shape. The report half takes neither --cells nor --csv: it is shown by family alone.";

Half half_named(const std::string& name)
{
  if (name != "tuning" && name != "report") throw std::invalid_argument(usage);
  return name == "report" ? Half::report : Half::tuning;
}

/// The best constant radius of the cell and the published method, in this order.
std::vector<ReferenceResult> measure_references(const TruthMesh& truth)
{
  const ConstantRadius best = best_constant_radius(truth);
  ReferenceResult constant, published;
  constant.method = best.bias_free ? "constant_bias_free" : "constant_offset_free";
  constant.take(best.metrics, best.radius);
  published.method = "published";
  published.take(measure_own(truth, published_method()).metrics, 0);
  return {constant, published};
}

FamilyRow measure(const FamilyCell& cell, ReferenceResults& known)
{
  const TruthMesh truth = cell.make(cell);
  if (truth.judged.empty()) throw std::runtime_error(cell.name() + ": no vertex can be judged");
  const OwnResult ours = measure_own(truth, {});
  FamilyRow row;
  row.family = cell.family;
  row.shape = cell.shape.name;
  row.group = cell.shape.group;
  row.level = cell.level;
  row.ours = ours.metrics;
  row.seconds = ours.seconds;
  row.noise = ours.noise / ours.average_edge;
  std::vector<ReferenceResult> references = known.find(cell, ours.average_edge);
  if (references.empty()) {
    references = measure_references(truth);
    known.add(cell, ours.average_edge, references);
  }
  row.constant = references.front();
  row.published = references.back();
  return row;
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File opened(const std::string& path)
{
  File file(path.empty() ? nullptr : std::fopen(path.c_str(), "w"), std::fclose);
  if (!path.empty() && !file) throw std::runtime_error("cannot write " + path);
  return file;
}

}  // namespace

void run_families(const std::vector<std::string>& argv)
{
  const Arguments arguments(argv, {"--seed", "--half", "--models", "--cells", "--csv", "--references"}, usage);
  const std::uint32_t seed = arguments.number("--seed", std::random_device()());
  const Half half = half_named(arguments.text("--half", "tuning"));
  const std::string filter = arguments.text("--cells"), path = arguments.text("--csv");
  const std::string references = arguments.text("--references");
  if (half == Half::report && !(filter + path).empty()) throw std::invalid_argument(usage);

  std::fprintf(stderr, "seed %u\n", seed);
  ReferenceResults known(references);
  const File csv = opened(path);
  if (csv) print_family_header(csv.get());
  std::vector<FamilyRow> rows;
  for (const FamilyCell& cell : draw_cells(half, seed, arguments.text("--models"))) {
    if (cell.name().find(filter) == std::string::npos) continue;
    rows.push_back(measure(cell, known));
    if (csv) print_family_row(rows.back(), csv.get());
  }
  std::printf("Seed %u, %s half.\n\n", seed, half == Half::report ? "report" : "tuning");
  print_family_table(rows, stdout);
}

}  // namespace accuracy
