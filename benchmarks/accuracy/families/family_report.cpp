// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/family_report.h"

#include <algorithm>
#include <cmath>

namespace accuracy {

namespace {

/// One line of the table: a summary of some rows.
struct Summary {
  std::size_t cells = 0, lost = 0;
  double log_constant = 0, worst = 0, log_published = 0, log_direction = 0, mean = 0, worst_mean = 0;
  double within_one = 0, within_two = 0;
  std::size_t directed = 0;

  void add(const FamilyRow& row)
  {
    ++cells;
    lost += row.ratio() > 1;
    log_constant += std::log(row.ratio());
    worst = std::max(worst, row.ratio());
    log_published += std::log(row.ours.mean / row.published.mean);
    if (row.ours.direction > 0 && row.constant.direction > 0) {
      log_direction += std::log(row.ours.direction / row.constant.direction);
      ++directed;
    }
    mean += row.ours.mean;
    worst_mean = std::max(worst_mean, row.ours.mean);
    within_one += row.ours.within_one;
    within_two += row.ours.within_two;
  }

  void print(const std::string& name, std::FILE* file) const
  {
    const double n = double(cells);
    std::fprintf(file, "| %s | %zu | %.2f | %.2f | %zu | %.2f | %.2f | %.4f | %.4f | %.2f | %.2f |\n", name.c_str(),
                 cells, std::exp(log_constant / n), worst, lost, std::exp(log_published / n),
                 directed > 0 ? std::exp(log_direction / double(directed)) : 0, mean / n, worst_mean, within_one / n,
                 within_two / n);
  }
};

}  // namespace

void print_family_header(std::FILE* file)
{
  std::fputs(
      "family,shape,group,level,vertices,mean,direction,noise,within_one,within_two,constant_mean,constant_direction,"
      "constant_radius,constant_method,published_mean,ratio,seconds\n",
      file);
}

void print_family_row(const FamilyRow& row, std::FILE* file)
{
  const Metrics& m = row.ours;
  const ReferenceResult& c = row.constant;
  std::fprintf(file, "%s,%s,%s,%.4g,%zu,%.5g,%.4g,%.4g,%.4f,%.4f,%.5g,%.4g,%.4g,%s,%.5g,%.4g,%.3g\n",
               row.family.c_str(), row.shape.c_str(), row.group.c_str(), row.level, m.vertices, m.mean, m.direction,
               row.noise, m.within_one, m.within_two, c.mean, c.direction, c.mean_radius, c.method.c_str(),
               row.published.mean, row.ratio(), row.seconds);
  std::fflush(file);
}

void print_family_table(const std::vector<FamilyRow>& rows, std::FILE* file)
{
  std::fputs(
      "| family | cells | default / best constant radius, geometric mean | worst | cells over 1 | default / published "
      "| "
      "directions | mean error | worst | within 1 s.e. | 2 s.e. |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
      file);
  Summary all;
  for (auto row = rows.begin(); row != rows.end();) {
    const std::string family = row->family;
    Summary summary;
    for (; row != rows.end() && row->family == family; ++row) {
      summary.add(*row);
      all.add(*row);
    }
    summary.print(family, file);
  }
  if (all.cells > 0) all.print("**all**", file);
}

}  // namespace accuracy
