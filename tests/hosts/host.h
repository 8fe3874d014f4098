// SPDX-License-Identifier: GPL-3.0-or-later
// The real MeshLab as tests drive it: a mesh and a filter script in, saved files and a log out.
#pragma once

#include <string>
#include <vector>

#include "registry.h"
#include "support/ply_file.h"
#include "support/program.h"

namespace test_support {

/// Where the build is, and the private MeshLab in it.
std::string build_folder();
std::string source_folder();

/// A MeshLab release that can run filter scripts without a window: 2020.09 by its meshlabserver, later ones by the
/// project's runner.
struct Host {
  std::string release;
  std::string plugin;       ///< file of the plugin that was built for it
  std::string unavailable;  ///< why it cannot run here; empty where it can
};
Host find_host(const std::string& release);

/// Names and values of the filter's parameters, as on the command line of write_filter_script.
using Assignments = std::vector<std::string>;

/// An .mlx of the filter, as users get it from write_filter_script.
std::string filter_script(const Assignments& assignments, const integral_invariant::filter::Filter& filter =
                                                              integral_invariant::filter::curvature_filter());
/// The script with one parameter's value replaced by whatever text.
std::string with_value(std::string script, const std::string& parameter, const std::string& value);

struct HostRun {
  int status = 0;
  std::string log;
};
/// Runs `script` on the mesh file and saves the mesh as `saved`. An empty mesh file name: no mesh is loaded.
HostRun run_script(const Host& host, const std::string& mesh_file, const std::string& script, const std::string& saved);

/// The command line of the project's runner inside that release's root.
std::vector<std::string> runner_command(const std::string& release, const std::vector<std::string>& arguments);

/// Every array that the filter exported is the core's own, to the rounding of single precision: curvatures and radii
/// within 1e-6 of their largest value, directions within 1e-5.
void expect_equal_to_core(const PlyFile& exported, const TriangleMesh& mesh, const Assignments& assignments);

}  // namespace test_support
