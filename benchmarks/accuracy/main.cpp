// SPDX-License-Identifier: GPL-3.0-or-later
// accuracy peers|ours|cost|oracle [--models FOLDER] [--cells TEXT] [--part I/N] > table.csv
// accuracy families [--seed N] [--half tuning|report] [--models FOLDER] [--cells TEXT] [--csv FILE]
// accuracy family_peers [--seed N] [--cells TEXT] > table.csv
// accuracy scans FOLDER
// accuracy frame SEED FILE...
// accuracy creases FILE...
//
// These are described in families/run_families.h, families/family_peers.h, cross_scan.h, frame.h, crease_quality.h.
// cost: processor time of the default settings, of the published ones, and of those with the default's radii. peers:
// each estimator at each radius of the sweep, one line each. ours: compute_curvature() with its defaults, one line a
// cell, judged at the same vertices of the same noisy meshes. oracle: the best choice of scales by the truth.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "cells.h"
#include "crease_quality.h"
#include "cross_scan.h"
#include "estimate.h"
#include "families/family_peers.h"
#include "families/run_families.h"
#include "frame.h"
#include "integral_invariant/pipeline.h"
#include "oracle.h"
#include "peers/peer.h"
#include "resource_use.h"
#include "support/shapes.h"

namespace {

using namespace accuracy;

/// Radii that peers are tried at, over the average edge length of the mesh without noise.
constexpr double peer_radii[] = {1, 1.5, 2, 3, 4, 5, 6, 7, 8, 10, 12};

struct Options {
  std::string mode, models, filter;
  int part = 0, parts = 1;
};

Options read_options(int argc, char** argv)
{
  Options o;
  o.mode = argc > 1 ? argv[1] : "";
  for (int i = 2; i + 1 < argc; i += 2) {
    if (!std::strcmp(argv[i], "--models")) o.models = argv[i + 1];
    if (!std::strcmp(argv[i], "--cells")) o.filter = argv[i + 1];
    if (!std::strcmp(argv[i], "--part")) std::sscanf(argv[i + 1], "%d/%d", &o.part, &o.parts);
  }
  constexpr std::array modes{"peers", "ours", "cost", "oracle"};
  if (std::find(modes.begin(), modes.end(), o.mode) == modes.end() || argc % 2)
    throw std::invalid_argument("usage: accuracy peers|ours|cost|oracle [--models FOLDER] [--cells TEXT] [--part I/N]");
  return o;
}

double seconds_since(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void print_header()
{
  std::puts(
      "shape,meshing,sigma,method,radius,vertices,mean,rms,median,p95,p99,direction,within_tenth,within_one,"
      "within_two,noise,seconds");
}

void print(const Cell& cell, const std::string& method, double radius, const Metrics& m, double noise, double seconds)
{
  std::printf("%s,%s,%g,%s,%g,%zu,%.6g,%.6g,%.6g,%.6g,%.6g,%.5g,%.4f,%.4f,%.4f,%.5g,%.4g\n", cell.shape.c_str(),
              cell.meshing.c_str(), cell.sigma, method.c_str(), radius, m.vertices, m.mean, m.rms, m.median, m.p95,
              m.p99, m.direction, m.within_tenth, m.within_one, m.within_two, noise, seconds);
  std::fflush(stdout);
}

void run_peers(const Cell& cell, const TruthMesh& truth)
{
  const TriangleMesh mesh = with_noise(truth, cell.sigma, cell.seed());
  const double edge = test_support::average_edge_length(truth.mesh);
  std::vector<Vec3> normals;
  for (const std::uint32_t v : truth.judged) normals.push_back(truth.normal[v]);

  PeerList peers;
#ifdef II_WITH_VCG
  add_vcg_ring_peers(mesh, peers);
  add_vcg_quadric_peer(mesh, peers);
  add_vcg_pca_peer(mesh, peers);
#endif
  add_cgal_jet_peers(mesh, peers);
  for (const auto& peer : peers)
    for (const double radius : peer_radii) {
      const auto start = std::chrono::steady_clock::now();
      const auto estimates = peer->estimate(truth.judged, normals, radius * edge);
      print(cell, peer->name(), peer->takes_radius() ? radius : 0, compare(truth, estimates), 0, seconds_since(start));
      if (!peer->takes_radius()) break;
    }
}

void run_ours(const Cell& cell, const TruthMesh& truth)
{
  const TriangleMesh mesh = with_noise(truth, cell.sigma, cell.seed());
  const auto start = std::chrono::steady_clock::now();
  const integral_invariant::Result r = integral_invariant::compute_curvature(mesh, {});
  const double seconds = seconds_since(start);
  std::vector<Estimate> estimates;
  for (const std::uint32_t v : truth.judged)
    estimates.push_back({r.kappa_max[v], r.kappa_min[v], r.dir_max[v], r.standard_error[v]});
  const double edge = test_support::average_edge_length(truth.mesh);
  print(cell, "ours", 0, compare(truth, estimates), r.noise / edge, seconds);
}

double processor_seconds(const TriangleMesh& mesh, const integral_invariant::Parameters& parameters)
{
  const double start = cpu_seconds();
  integral_invariant::compute_curvature(mesh, parameters);
  return cpu_seconds() - start;
}

/// Processor times, each of the fastest of five runs in turn: the machine is no faster for the one than for the other.
void run_cost(const Cell& cell, const TruthMesh& truth)
{
  const TriangleMesh mesh = with_noise(truth, cell.sigma, cell.seed());
  const integral_invariant::Parameters automatic, published = integral_invariant::published_method();
  std::array<integral_invariant::Parameters, 3> settings{automatic, published, published};
  // The radii of the default settings, so that both see the same balls.
  const double edge = test_support::average_edge_length(mesh);
  integral_invariant::Parameters& same_balls = settings.back();
  same_balls.scales = automatic.scales;
  same_balls.spacing = integral_invariant::ScaleSpacing::geometric;
  same_balls.r_min = 1.5 * edge;
  same_balls.r_max = 16 * edge;
  constexpr int runs = 5;
  std::array<double, 3> fastest{1e300, 1e300, 1e300};
  for (int run = 0; run < runs; ++run)
    for (std::size_t i = 0; i < settings.size(); ++i)
      fastest[i] = std::min(fastest[i], processor_seconds(mesh, settings[i]));
  std::printf("%s,%s,%g,%zu,%.4g,%.4g,%.4g\n", cell.shape.c_str(), cell.meshing.c_str(), cell.sigma,
              mesh.positions.size(), fastest[0], fastest[1], fastest[2]);
  std::fflush(stdout);
}

/// The modes that do not go through the cells of cells.h; false: it is none of them.
bool runs_mode_of_its_own(int argc, char** argv)
{
  const std::string mode = argc > 1 ? argv[1] : "";
  const std::vector<std::string> arguments(argv + std::min(argc, 2), argv + argc);
#ifdef II_WITH_VCG
  if (mode == "families") {
    run_families(argc, argv);
    return true;
  }
  if (mode == "family_peers") {
    run_family_peers(argc, argv);
    return true;
  }
#endif
  if (mode == "scans" && arguments.size() == 1)
    print_cross_scan_scores(arguments[0]);
  else if (mode == "frame" && arguments.size() > 1)
    print_frame_dependence({arguments.begin() + 1, arguments.end()}, std::uint32_t(std::stoul(arguments[0])));
  else if (mode == "creases" && !arguments.empty())
    print_crease_quality(arguments);
  else
    return false;
  return true;
}

}  // namespace

int main(int argc, char** argv)
try {
  if (runs_mode_of_its_own(argc, argv)) return EXIT_SUCCESS;
  const Options options = read_options(argc, argv);
  if (options.mode == "cost")
    std::puts("shape,meshing,sigma,vertices,default_seconds,published_seconds,same_balls_seconds");
  else if (options.mode == "oracle")
    print_oracle_header();
  else
    print_header();
  TruthMesh truth;
  std::string loaded;
  int mesh = -1;
  for (const Cell& cell : all_cells(options.models)) {
    const std::string name = cell.shape + '/' + cell.meshing;
    if (name != loaded && cell.sigma == 0) ++mesh;
    if (mesh % options.parts != options.part || cell.name().find(options.filter) == std::string::npos) continue;
    if (name != loaded) truth = load(cell, options.models);
    loaded = name;
    if (options.mode == "peers") run_peers(cell, truth);
    if (options.mode == "ours") run_ours(cell, truth);
    if (options.mode == "cost") run_cost(cell, truth);
    if (options.mode == "oracle") print_oracle(cell, truth, with_noise(truth, cell.sigma, cell.seed()));
  }
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return EXIT_FAILURE;
}
