// SPDX-License-Identifier: GPL-3.0-or-later
// meshlab_script_runner: filter scripts on MeshLab 2022.02 and later, which have no meshlabserver.
#include <cstdio>

#include "command_line.h"
#include "exit_status.h"
#include "session.h"
#include "terminal.h"

namespace {

void list_filters(const runner::Session& session)
{
  for (const std::string& name : session.filter_names()) std::printf("%s\n", name.c_str());
}

void run(const runner::CommandLine& line, runner::Session& session)
{
  session.load_own_plugins(line.plugin_folder);
  for (const std::string& plugin : line.plugins) session.load_plugin(plugin);
  if (line.list_filters) return list_filters(session);
  for (const std::string& mesh : line.inputs) session.load_mesh(mesh);
  for (const std::string& script : line.scripts) session.run_script(script);
  if (!line.output.empty()) session.save_current_mesh(line.output, line.ascii);
}

}  // namespace

int main(int argc, char** argv)
{
  try {
    const runner::CommandLine line = runner::parse_command_line({argv + 1, argv + argc});
    runner::set_quiet(line.quiet);
    if (line.help) return std::fputs(runner::help_text().c_str(), stdout), 0;
    if (line.version) return std::printf("for MeshLab %s\n", runner::Session::meshlab_version().c_str()), 0;
    runner::Session session(argv[0]);
    run(line, session);
    runner::clear_progress();
    return int(runner::ExitStatus::done);
  } catch (const runner::Failure& failure) {
    runner::complain(failure.what());
    return int(failure.status());
  } catch (const std::exception& error) {
    runner::complain(error.what());
    return int(runner::ExitStatus::filter_failed);
  }
}
