// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_modes.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <stdexcept>

#include "arguments.h"
#include "cells.h"
#include "own_method.h"
#include "peers/peer.h"
#include "peers/sweep.h"
#include "resource_use.h"
#include "support/shapes.h"

namespace accuracy {

using integral_invariant::Parameters;

namespace {

constexpr const char* usage = "usage: accuracy peers|ours|cost [--models FOLDER] [--cells TEXT] [--part I/N]";
constexpr const char* metrics_header =
    "shape,meshing,sigma,method,radius,vertices,mean,rms,median,p95,p99,direction,within_tenth,within_one,"
    "within_two,noise,seconds";

void print(const Cell& cell, const std::string& method, double radius, const Metrics& m, double noise, double seconds)
{
  std::printf("%s,%s,%g,%s,%g,%zu,%.6g,%.6g,%.6g,%.6g,%.6g,%.5g,%.4f,%.4f,%.4f,%.5g,%.4g\n", cell.shape.c_str(),
              cell.meshing.c_str(), cell.sigma, method.c_str(), radius, m.vertices, m.mean, m.rms, m.median, m.p95,
              m.p99, m.direction, m.within_tenth, m.within_one, m.within_two, noise, seconds);
  std::fflush(stdout);
}

void run_peers(const Cell& cell, const TruthMesh& truth, double edge)
{
  PeerList peers;
#ifdef II_WITH_VCG
  add_vcg_ring_peers(truth.mesh, peers);
  add_vcg_quadric_peer(truth.mesh, peers);
  add_vcg_pca_peer(truth.mesh, peers);
#endif
  add_cgal_jet_peers(truth.mesh, peers);
  for (const auto& peer : peers)
    sweep_radii(*peer, truth, edge, [&](double radius, const Metrics& metrics, double seconds) {
      print(cell, peer->name(), radius, metrics, 0, seconds);
    });
}

void run_ours(const Cell& cell, const TruthMesh& truth, double edge)
{
  const OwnResult own = measure_own(truth, {});
  print(cell, "ours", 0, own.metrics, own.noise / edge, own.seconds);
}

double processor_seconds(const TriangleMesh& mesh, const Parameters& parameters)
{
  const double start = cpu_seconds();
  integral_invariant::compute_curvature(mesh, parameters);
  return cpu_seconds() - start;
}

/// The published method at the radii of the default settings, so that both evaluate the same balls.
Parameters published_at_default_radii(double edge)
{
  Parameters p = integral_invariant::published_method();
  p.scales = Parameters().scales;
  p.spacing = integral_invariant::ScaleSpacing::geometric;
  p.r_min = 1.5 * edge;
  p.r_max = 16 * edge;
  return p;
}

/// Processor time, the best of several rounds. The settings take turns, so that a slow moment of the machine does not
/// count against one of them.
void run_cost(const Cell& cell, const TruthMesh& truth, double)
{
  constexpr int rounds = 5;
  const std::array<Parameters, 3> settings{Parameters(), integral_invariant::published_method(),
                                           published_at_default_radii(test_support::average_edge_length(truth.mesh))};
  std::array<double, 3> fastest{1e300, 1e300, 1e300};
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < settings.size(); ++i)
      fastest[i] = std::min(fastest[i], processor_seconds(truth.mesh, settings[i]));
  std::printf("%s,%s,%g,%zu,%.4g,%.4g,%.4g\n", cell.shape.c_str(), cell.meshing.c_str(), cell.sigma,
              truth.mesh.positions.size(), fastest[0], fastest[1], fastest[2]);
  std::fflush(stdout);
}

struct Mode {
  const char *name, *header;
  /// `edge`: average edge length of the mesh without noise.
  std::function<void(const Cell&, const TruthMesh&, double edge)> run;
};

Mode mode_named(const std::string& name)
{
  for (const Mode& mode :
       {Mode{"peers", metrics_header, run_peers}, Mode{"ours", metrics_header, run_ours},
        Mode{"cost", "shape,meshing,sigma,vertices,default_seconds,published_seconds,same_balls_seconds", run_cost}})
    if (mode.name == name) return mode;
  throw std::invalid_argument(usage);
}

/// Which of several processes this one is: "I/N" is the I-th of N, from 0.
struct Part {
  int index = 0, count = 1;

  explicit Part(const std::string& text)
  {
    if (std::sscanf(text.c_str(), "%d/%d", &index, &count) != 2 || count < 1) throw std::invalid_argument(usage);
  }
};

}  // namespace

void run_cells(const std::vector<std::string>& argv)
{
  const Mode mode = mode_named(argv.size() > 1 ? argv[1] : "");
  const Arguments arguments(argv, {"--models", "--cells", "--part"}, usage);
  const std::string models = arguments.text("--models"), filter = arguments.text("--cells");
  const Part part(arguments.text("--part", "0/1"));

  std::puts(mode.header);
  TruthMesh exact;
  std::string loaded;
  int mesh = -1;
  for (const Cell& cell : all_cells(models)) {
    const std::string name = cell.shape + '/' + cell.meshing;
    // The cells of one mesh follow one another and start with the one without noise.
    if (cell.sigma == 0) ++mesh;
    if (mesh % part.count != part.index || cell.name().find(filter) == std::string::npos) continue;
    if (name != loaded) exact = load(cell, models);
    loaded = name;
    TruthMesh truth = exact;
    truth.mesh = with_noise(exact, cell.sigma, cell.seed());
    mode.run(cell, truth, test_support::average_edge_length(exact.mesh));
  }
}

}  // namespace accuracy
