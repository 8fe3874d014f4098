// SPDX-License-Identifier: GPL-3.0-or-later
// sample_mesh: writes the mesh that is measured when the user names none.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "polygonise.h"

namespace {

constexpr double default_edge = 0.018;  // about 60,000 vertices; the smallest knobs are seven edges wide
constexpr double min_edge = 0.004, max_edge = 0.1;

constexpr const char* usage =
    "Usage: sample_mesh OUT.ply [EDGE]\n\n"
    "Writes a closed surface with features of clearly different size: a unit sphere with round knobs, fused with "
    "copies of\n"
    "itself at the scales 1 : 3 and 1 : 8. EDGE is the edge length, 0.004 to 0.1 (default 0.018). The same EDGE gives "
    "the\n"
    "same mesh.\n";

}  // namespace

int main(int argc, char** argv)
{
  const std::string first = argc > 1 ? argv[1] : "";
  if (argc < 2 || argc > 3 || first == "-h" || first == "--help") {
    std::fputs(usage, argc < 2 || argc > 3 ? stderr : stdout);
    return argc < 2 || argc > 3 ? 2 : 0;
  }
  double edge = default_edge;
  if (argc == 3) {
    char* end = nullptr;
    edge = std::strtod(argv[2], &end);
    if (*end != '\0' || !(edge >= min_edge && edge <= max_edge)) {
      std::fprintf(stderr, "sample_mesh: EDGE must be a number from %g to %g, not \"%s\".\n", min_edge, max_edge,
                   argv[2]);
      return 2;
    }
  }
  try {
    const samples::MeshSize size = samples::polygonise(samples::sample_solid(), edge, first);
    std::printf("%s: %zu vertices, %zu triangles\n", first.c_str(), size.vertices, size.triangles);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sample_mesh: %s.\n", error.what());
    return 1;
  }
}
