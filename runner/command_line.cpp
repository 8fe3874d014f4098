// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include "exit_status.h"

namespace runner {

namespace {

[[noreturn]] void refuse(const std::string& sentence)
{
  throw Failure(ExitStatus::bad_command_line, sentence + " See --help.");
}

void check(const CommandLine& line)
{
  if (line.help || line.version || line.list_filters) return;
  if (line.inputs.empty()) refuse("No mesh was named: -i MESH.");
  if (line.scripts.empty() && line.output.empty())
    refuse("Nothing was asked for: name a filter script (-s SCRIPT.mlx), an output (-o MESH), or both.");
}

}  // namespace

CommandLine parse_command_line(const std::vector<std::string>& arguments)
{
  CommandLine line;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& option = arguments[i];
    const auto value = [&]() -> const std::string& {
      if (i + 1 == arguments.size()) refuse("The option " + option + " needs a value.");
      return arguments[++i];
    };
    if (option == "-i" || option == "--input")
      line.inputs.push_back(value());
    else if (option == "-s" || option == "--script")
      line.scripts.push_back(value());
    else if (option == "-o" || option == "--output")
      line.output = value();
    else if (option == "--plugin")
      line.plugins.push_back(value());
    else if (option == "--plugin-folder")
      line.plugin_folder = value();
    else if (option == "--ascii")
      line.ascii = true;
    else if (option == "-q" || option == "--quiet")
      line.quiet = true;
    else if (option == "--list-filters")
      line.list_filters = true;
    else if (option == "-h" || option == "--help")
      line.help = true;
    else if (option == "--version")
      line.version = true;
    else
      refuse("There is no option " + option + ".");
  }
  check(line);
  return line;
}

std::string help_text()
{
  return R"(Usage: meshlab_script_runner -i MESH [-i MESH ...] [-s SCRIPT.mlx ...] [-o MESH] [options]

Runs MeshLab's filter scripts without a window: loads the meshes, applies the filters of each script in turn to the
current mesh (the last one loaded, or what a filter has made current) and saves it. No display is needed.

  -i, --input MESH       a mesh in any format that MeshLab reads; several become several layers
  -s, --script FILE.mlx  a filter script; parameters that it does not name have the filter's defaults
  -o, --output MESH      where the current mesh is saved, in the format that its name ends in, with everything that the
                         format can hold; PLY also with all named attributes
      --ascii            text rather than binary, where the format has both
      --plugin FILE      a plugin to load after MeshLab's own (several are possible)
      --plugin-folder F  where MeshLab's own plugins are (default: beside its library)
      --list-filters     print the names of all filters
  -q, --quiet            print neither progress nor logs, only what goes wrong
  -h, --help             this text
      --version          the version of MeshLab that this program works with

Exit status: 0 all done; 1 a filter failed or refused; 2 bad command line; 3 a plugin named by --plugin was not loaded;
4 a mesh was not read; 5 a script was not read, or names an unknown filter or parameter; 6 the output was not written.
Nothing is saved unless every filter succeeded.
)";
}

}  // namespace runner
