// SPDX-License-Identifier: GPL-3.0-or-later
// core_curvature MESH.ply OUT [parameter=value ...]: what the core computes, for tests that are not written in C++.
// OUT holds one row of ten doubles a vertex: kmax, kmin, radius, confidence, dirmax (3), dirmin (3).
#include <cstdio>
#include <exception>
#include <fstream>

#include "filter_script.h"
#include "integral_invariant/curvature.h"
#include "registry.h"
#include "support/ply_file.h"

namespace {

void write_rows(const integral_invariant::Result& r, const char* path)
{
  std::ofstream out(path, std::ios::binary);
  for (std::size_t v = 0; v < r.kappa_max.size(); ++v) {
    const double row[] = {r.kappa_max[v], r.kappa_min[v], r.radius[v],    double(r.confidence[v]), r.dir_max[v].x,
                          r.dir_max[v].y, r.dir_max[v].z, r.dir_min[v].x, r.dir_min[v].y,          r.dir_min[v].z};
    out.write(reinterpret_cast<const char*>(row), sizeof row);
  }
}

}  // namespace

int main(int argc, char** argv)
{
  if (argc < 3) return 2;
  try {
    using namespace integral_invariant;
    filter::Request request;
    for (int i = 3; i < argc; ++i) filter::store_assignment(filter::curvature_filter(), argv[i], request);
    write_rows(compute_curvature(test_support::read_ply(argv[1]).mesh(), request.part<Parameters>()), argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "core_curvature: %s\n", error.what());
    return 1;
  }
}
