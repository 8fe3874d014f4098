// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/run_families.h"

#include <chrono>
#include <cstdio>
#include <cstring>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "families/constant_radius.h"
#include "families/families.h"
#include "families/family_report.h"
#include "integral_invariant/pipeline.h"
#include "support/shapes.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

struct FamilyOptions {
  std::uint32_t seed = std::random_device()();
  Half half = Half::tuning;
  std::string cells, csv, models;
};

[[noreturn]] void explain_usage()
{
  throw std::invalid_argument(
      "usage: accuracy families [--seed N] [--half tuning|report] [--models FOLDER] [--cells TEXT] [--csv FILE]\n"
      "TEXT is part of family/shape. The report half takes no --cells and no --csv: it is shown by family alone.");
}

FamilyOptions read_family_options(int argc, char** argv)
{
  FamilyOptions o;
  if (argc % 2) explain_usage();
  for (int i = 2; i + 1 < argc; i += 2) {
    const std::string option = argv[i], value = argv[i + 1];
    if (option == "--seed")
      o.seed = std::uint32_t(std::stoul(value));
    else if (option == "--half" && (value == "tuning" || value == "report"))
      o.half = value == "report" ? Half::report : Half::tuning;
    else if (option == "--cells")
      o.cells = value;
    else if (option == "--models")
      o.models = value;
    else if (option == "--csv")
      o.csv = value;
    else
      explain_usage();
  }
  if (o.half == Half::report && !(o.cells.empty() && o.csv.empty())) explain_usage();
  return o;
}

std::vector<Estimate> estimates_at(const TruthMesh& truth, const Result& r)
{
  std::vector<Estimate> estimates;
  for (const std::uint32_t v : truth.judged)
    estimates.push_back({r.kappa_max[v], r.kappa_min[v], r.dir_max[v], r.standard_error[v]});
  return estimates;
}

FamilyRow measure(const FamilyCell& cell)
{
  const TruthMesh truth = cell.make(cell);
  if (truth.judged.empty()) throw std::runtime_error(cell.name() + ": no vertex can be judged");
  FamilyRow row{cell.family, cell.shape.name, cell.shape.group, cell.level, {}, 0, {}, {}, 0};
  const auto start = std::chrono::steady_clock::now();
  const Result ours = compute_curvature(truth.mesh, {});
  row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  row.ours = compare(truth, estimates_at(truth, ours));
  row.noise = ours.noise / ours.average_edge;
  row.constant = best_constant_radius(truth);
  row.published = compare(truth, estimates_at(truth, compute_curvature(truth.mesh, published_method())));
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

void run_families(int argc, char** argv)
{
  const FamilyOptions options = read_family_options(argc, argv);
  std::fprintf(stderr, "seed %u\n", options.seed);
  const File csv = opened(options.csv);
  if (csv) print_family_header(csv.get());
  std::vector<FamilyRow> rows;
  for (const FamilyCell& cell : draw_cells(options.half, options.seed, options.models)) {
    if (cell.name().find(options.cells) == std::string::npos) continue;
    rows.push_back(measure(cell));
    if (csv) print_family_row(rows.back(), csv.get());
  }
  std::printf("Seed %u, %s half.\n\n", options.seed, options.half == Half::report ? "report" : "tuning");
  print_family_table(rows, stdout);
}

}  // namespace accuracy
