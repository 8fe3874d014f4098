// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/family_peers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "arguments.h"
#include "families/families.h"
#include "families/reference_results.h"
#include "own_method.h"
#include "peers/peer.h"
#include "peers/sweep.h"
#include "support/shapes.h"

namespace accuracy {

namespace {

constexpr const char* usage = "usage: accuracy family_peers [--seed N] [--cells TEXT] [--peers FILE]";
/// Some estimators take a tenth of a second a vertex at the largest radii.
constexpr std::size_t judged_vertices = 200;

struct Comparison {
  std::string family, shape;
  OwnResult ours;
  std::vector<ReferenceResult> peers;
  ReferenceResult by_mean, by_direction;  ///< the best peer by each error

  /// Chooses the best peer, leaving out the one named.
  void choose_best(const std::string& left_out = "")
  {
    by_mean = by_direction = {};
    for (const ReferenceResult& peer : peers) {
      if (peer.method == left_out) continue;
      if (peer.mean < by_mean.mean) by_mean = peer;
      if (peer.direction < by_direction.direction) by_direction = peer;
    }
  }
  double mean_ratio() const { return ours.metrics.mean / by_mean.mean; }
  bool has_directions() const { return by_direction.direction > 0 && ours.metrics.direction > 0; }
  double direction_ratio() const { return ours.metrics.direction / by_direction.direction; }
};

/// Keeps every n-th judged vertex; they are sorted by index.
void thin_out(TruthMesh& truth)
{
  const std::size_t count = truth.judged.size();
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < std::min(count, judged_vertices); ++i)
    kept.push_back(truth.judged[i * count / std::min(count, judged_vertices)]);
  truth.judged = kept;
}

std::vector<ReferenceResult> measure_peers(const TruthMesh& truth, double edge)
{
  PeerList peers;
  add_vcg_quadric_peer(truth.mesh, peers);
  add_cgal_jet_peers(truth.mesh, peers);
  add_corrected_current_peers(truth.mesh, peers);
  add_algebraic_sphere_peer(truth.mesh, peers);
  std::vector<ReferenceResult> results;
  for (const auto& peer : peers) {
    ReferenceResult best;
    best.method = peer->name();
    sweep_radii(*peer, truth, edge, [&](double radius, const Metrics& metrics, double) { best.take(metrics, radius); });
    results.push_back(best);
  }
  return results;
}

Comparison compare_on(const FamilyCell& cell, ReferenceResults& references)
{
  TruthMesh truth = cell.make(cell);
  thin_out(truth);
  const double edge = test_support::average_edge_length(truth.mesh);
  std::vector<ReferenceResult> peers = references.find(cell, edge);
  if (peers.empty()) {
    peers = measure_peers(truth, edge);
    references.add(cell, edge, peers);
  }
  Comparison comparison{cell.family, cell.shape.name, measure_own(truth, {}), peers, {}, {}};
  comparison.choose_best();
  return comparison;
}

void print_summary(const std::string& name, const std::vector<Comparison>& comparisons)
{
  double logs = 0, worst = 0, direction_logs = 0, worst_direction = 0, directed = 0;
  int won = 0;
  for (const Comparison& c : comparisons) {
    logs += std::log(c.mean_ratio());
    worst = std::max(worst, c.mean_ratio());
    won += c.mean_ratio() < 1;
    if (!c.has_directions()) continue;
    direction_logs += std::log(c.direction_ratio());
    worst_direction = std::max(worst_direction, c.direction_ratio());
    ++directed;
  }
  std::printf("| %s | %zu | %d | %.2f | %.2f | %.2f | %.2f |\n", name.c_str(), comparisons.size(), won,
              std::exp(logs / double(comparisons.size())), worst, std::exp(direction_logs / std::max(1.0, directed)),
              worst_direction);
}

/// The cells of the families whose names begin with `name`.
std::vector<Comparison> beginning_with(const std::string& name, const std::vector<Comparison>& all)
{
  std::vector<Comparison> chosen;
  for (const Comparison& c : all)
    if (c.family.rfind(name, 0) == 0) chosen.push_back(c);
  return chosen;
}

void print_white_noise(const std::vector<Comparison>& all)
{
  std::vector<Comparison> white = beginning_with("white_", all);
  if (white.empty()) return;
  print_summary("**white, all levels**", white);
  // On the torus they have next to no bias, even as large as its tube: they win there by the shape, not by the noise.
  for (Comparison& c : white) c.choose_best("algebraic_spheres");
  print_summary("**the same without algebraic spheres**", white);
}

void print_summaries(const std::vector<Comparison>& all)
{
  std::puts(
      "| family | cells | best in | κ: ours / best other, geometric mean | worst | directions: geometric mean | worst "
      "|\n|---|---|---|---|---|---|---|");
  std::string last;
  for (const Comparison& c : all) {
    if (c.family != last) print_summary(c.family, beginning_with(c.family, all));
    last = c.family;
  }
  print_white_noise(all);
}

void print_cells(const std::vector<Comparison>& all)
{
  std::puts(
      "\n| family | shape | mean error | best other | at | ratio | direction ° | best other ° | at | ratio | coverage "
      "1, 2 s.e. | σ̂/ē |\n|---|---|---|---|---|---|---|---|---|---|---|---|");
  for (const Comparison& c : all)
    std::printf("| %s | %s | %.4f | %.4f | %s %gē | %.2f | %.2f | %.2f | %s %gē | %.2f | %.2f, %.2f | %.3f |\n",
                c.family.c_str(), c.shape.c_str(), c.ours.metrics.mean, c.by_mean.mean, c.by_mean.method.c_str(),
                c.by_mean.mean_radius, c.mean_ratio(), c.ours.metrics.direction, c.by_direction.direction,
                c.by_direction.method.c_str(), c.by_direction.direction_radius,
                c.has_directions() ? c.direction_ratio() : 0, c.ours.metrics.within_one, c.ours.metrics.within_two,
                c.ours.noise / c.ours.average_edge);
}

}  // namespace

void run_family_peers(const std::vector<std::string>& argv)
{
  const Arguments arguments(argv, {"--seed", "--cells", "--peers"}, usage);
  const std::string filter = arguments.text("--cells");
  ReferenceResults references(arguments.text("--peers"));
  std::vector<Comparison> comparisons;
  for (const FamilyCell& cell : draw_peer_cells(arguments.number("--seed", 1))) {
    if (cell.name().find(filter) == std::string::npos) continue;
    comparisons.push_back(compare_on(cell, references));
    std::fprintf(stderr, "%s: %.2f\n", cell.name().c_str(), comparisons.back().mean_ratio());
  }
  print_summaries(comparisons);
  print_cells(comparisons);
}

}  // namespace accuracy
