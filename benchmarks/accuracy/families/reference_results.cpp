// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/reference_results.h"

#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace accuracy {

namespace {

constexpr const char* header = "cell,level,seed,edge,method,mean,mean_radius,direction,direction_radius";

/// Compilers may differ in the last bits of a mesh.
bool are_equal(double a, double b) { return std::abs(a - b) <= 1e-4 * std::abs(b); }

}  // namespace

void ReferenceResult::take(const Metrics& metrics, double radius)
{
  if (metrics.mean < mean) {
    mean = metrics.mean;
    mean_radius = radius;
  }
  if (metrics.direction < direction) {
    direction = metrics.direction;
    direction_radius = radius;
  }
}

ReferenceResults::ReferenceResults(const std::string& path) : path_(path)
{
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    for (char& c : line)
      if (c == ',') c = ' ';
    std::istringstream fields(line);
    Row row;
    ReferenceResult& r = row.result;
    fields >> row.cell >> row.level >> row.seed >> row.edge >> r.method >> r.mean >> r.mean_radius >> r.direction >>
        r.direction_radius;
    if (!fields) throw std::runtime_error(path + ": this line is no reference result: " + line);
    rows_.push_back(row);
  }
}

std::vector<ReferenceResult> ReferenceResults::find(const FamilyCell& cell, double edge) const
{
  std::vector<ReferenceResult> found;
  for (const Row& row : rows_)
    if (row.cell == cell.name() && row.seed == cell.seed && are_equal(row.level, cell.level) &&
        are_equal(row.edge, edge))
      found.push_back(row.result);
  return found;
}

void ReferenceResults::add(const FamilyCell& cell, double edge, const std::vector<ReferenceResult>& results)
{
  for (const ReferenceResult& result : results) {
    rows_.push_back({cell.name(), cell.level, cell.seed, edge, result});
    if (!path_.empty()) write(rows_.back());
  }
}

void ReferenceResults::write(const Row& row) const
{
  const bool is_new = !std::ifstream(path_).good();
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path_.c_str(), "a"), std::fclose);
  if (!file) throw std::runtime_error("cannot write " + path_);
  if (is_new) std::fprintf(file.get(), "%s\n", header);
  const ReferenceResult& r = row.result;
  std::fprintf(file.get(), "%s,%.6g,%u,%.6g,%s,%.5g,%g,%.4g,%g\n", row.cell.c_str(), row.level, row.seed, row.edge,
               r.method.c_str(), r.mean, r.mean_radius, r.direction, r.direction_radius);
}

}  // namespace accuracy
