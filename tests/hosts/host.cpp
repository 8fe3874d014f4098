// SPDX-License-Identifier: GPL-3.0-or-later
#include "hosts/host.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "filter_script.h"
#include "integral_invariant/curvature.h"

namespace test_support {

namespace {

namespace filter = integral_invariant::filter;

filter::Request request_of(const Assignments& assignments, const filter::Filter& of = filter::curvature_filter())
{
  filter::Request request;
  for (const std::string& assignment : assignments) filter::store_assignment(of, assignment, request);
  return request;
}

void expect_scalars(const char* name, const std::vector<double>& actual, const std::vector<double>& expected)
{
  ASSERT_EQ(actual.size(), expected.size()) << name;
  double largest = 0, difference = 0;
  for (std::size_t v = 0; v < actual.size(); ++v) {
    ASSERT_TRUE(std::isfinite(actual[v])) << name << " of vertex " << v;
    largest = std::max(largest, std::abs(expected[v]));
    difference = std::max(difference, std::abs(actual[v] - expected[v]));
  }
  EXPECT_LE(difference, 1e-6 * largest) << name;
}

void expect_directions(const char* name, const std::vector<Vec3>& actual, const std::vector<Vec3>& expected)
{
  ASSERT_EQ(actual.size(), expected.size()) << name;
  double difference = 0;
  for (std::size_t v = 0; v < actual.size(); ++v) difference = std::max(difference, norm(actual[v] - expected[v]));
  EXPECT_LE(difference, 1e-5) << name;
}

}  // namespace

std::string build_folder() { return environment("II_BUILD", II_BUILD_FOLDER); }
std::string source_folder() { return II_SOURCE_FOLDER; }

Host find_host(const std::string& release)
{
  const bool own = release == "2020.09";
  const std::string folder = own ? build_folder() : build_folder() + "/hosts/" + release;
  const std::string program = folder + (own ? "/meshlab-2020.09/bin/meshlabserver" : "/runner/meshlab_script_runner");
  Host host{release, folder + "/filter_feature_adapted_ii/libfilter_feature_adapted_ii.so", ""};
  const std::string reason = read_text(build_folder() + "/hosts/" + release + ".unavailable");
  if (!reason.empty())
    host.unavailable = "not run: " + reason;
  else if (!std::filesystem::exists(program))
    host.unavailable = "not run: there is no " + program + "; scripts/test makes it";
  return host;
}

std::string filter_script(const Assignments& assignments, const filter::Filter& of)
{
  return filter::filter_script(of, request_of(assignments, of));
}

std::string with_value(std::string script, const std::string& parameter, const std::string& value)
{
  const std::size_t name = script.find("name=\"" + parameter + "\"");
  if (name == std::string::npos) throw std::invalid_argument("the script has no parameter " + parameter);
  const std::size_t begin = script.find("value=\"", name) + 7;
  return script.replace(begin, script.find('"', begin) - begin, value);
}

HostRun run_script(const Host& host, const std::string& mesh_file, const std::string& script, const std::string& saved)
{
  const TemporaryFolder folder;
  write_text(folder / "script.mlx", script);
  std::vector<std::string> command = {"timeout", "250"};  // a host that hangs must not hang the tests
  const auto add = [&command](const std::vector<std::string>& words) {
    command.insert(command.end(), words.begin(), words.end());
  };
  if (host.release == "2020.09")
    add({"xvfb-run", "-a", build_folder() + "/meshlab-2020.09/bin/meshlabserver"});
  else
    add(runner_command(host.release, {"--plugin", host.plugin}));
  if (!mesh_file.empty()) add({"-i", mesh_file});
  if (!saved.empty()) add({"-o", saved});
  if (!saved.empty() && host.release == "2020.09") add({"-m", "vq", "vr", "vc", "vn"});
  add({"-s", folder / "script.mlx"});
  const ProgramResult result = run_program(command);
  return {result.status, result.output};
}

std::vector<std::string> runner_command(const std::string& release, const std::vector<std::string>& arguments)
{
  std::vector<std::string> command = {source_folder() + "/scripts/hosts/run_in_host", release,
                                      build_folder() + "/hosts/" + release + "/runner/meshlab_script_runner"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

void expect_equal_to_core(const PlyFile& exported, const TriangleMesh& mesh, const Assignments& assignments)
{
  const integral_invariant::Result core = integral_invariant::compute_curvature(
      in_single_precision(mesh), request_of(assignments).part<integral_invariant::Parameters>());
  expect_scalars("ii_kmax", exported.property("ii_kmax"), core.kappa_max);
  expect_scalars("ii_kmin", exported.property("ii_kmin"), core.kappa_min);
  expect_scalars("ii_radius", exported.property("ii_radius"), core.radius);
  expect_scalars("ii_confidence", exported.property("ii_confidence"), {core.confidence.begin(), core.confidence.end()});
  expect_directions("ii_dirmax", exported.vectors("ii_dirmax"), core.dir_max);
  expect_directions("ii_dirmin", exported.vectors("ii_dirmin"), core.dir_min);
}

}  // namespace test_support
