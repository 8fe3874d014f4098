// SPDX-License-Identifier: GPL-3.0-or-later
#include "session.h"

#include <dlfcn.h>

#include <clocale>
#include <filesystem>

#include <QApplication>
#include <QDir>
#include <common/filterscript.h>
#include <common/globals.h>
#include <common/ml_document/mesh_document.h>
#include <common/plugins/plugin_manager.h>
#include <common/utilities/load_save.h>

#include "exit_status.h"
#include "saved_files.h"
#include "terminal.h"

namespace runner {

namespace {

namespace fs = std::filesystem;
using vcg::tri::io::Mask;

/// The sentences of MeshLab's exceptions are spread over lines, for message boxes.
std::string in_one_line(const std::string& text) { return QString::fromStdString(text).simplified().toStdString(); }

PluginManager& plugin_manager() { return meshlab::pluginManagerInstance(); }

/// Linux distributions keep the plugins beside the library, wherever this program stands.
QString folder_beside_library()
{
  Dl_info info;
  if (!dladdr(reinterpret_cast<void*>(&meshlab::pluginManagerInstance), &info)) return meshlab::defaultPluginPath();
  return QFileInfo(QString(info.dli_fname)).dir().filePath("plugins");
}

/// MeshLab and Qt tell developers much through Qt's messages, the filters' logs once more among it.
void drop_chatter(QtMsgType type, const QMessageLogContext&, const QString& message)
{
  if (type == QtCriticalMsg || type == QtFatalMsg) complain(in_one_line(message.toStdString()));
}

struct Step {
  QAction* action;
  FilterPlugin* plugin;
  const RichParameterList* given;
};

[[noreturn]] void refuse_script(const std::string& file, const std::string& reason)
{
  throw Failure(ExitStatus::script_not_usable, file + ": " + reason);
}

Step checked_step(const std::string& file, const FilterNameParameterValuesPair& filter, const MeshDocument& document)
{
  const std::string name = filter.first.toStdString();
  QAction* action = plugin_manager().filterAction(filter.first);
  if (!action) refuse_script(file, "there is no filter '" + name + "' (--list-filters names all of them).");
  FilterPlugin* plugin = plugin_manager().getFilterPluginFromAction(action);
  if (plugin->requiresGLContext(action)) refuse_script(file, "the filter '" + name + "' needs MeshLab's window.");
  const RichParameterList defaults = plugin->initParameterList(action, document);
  for (const RichParameter& given : filter.second) {
    const std::string parameter = given.name().toStdString();
    if (!defaults.hasParameter(given.name()))
      refuse_script(file, "the filter '" + name + "' has no parameter '" + parameter + "'.");
    // MeshLab would read the value as the type that it expects, whatever it is.
    if (defaults.getParameterByName(given.name()).value().typeName() != given.value().typeName())
      refuse_script(file, "the parameter '" + parameter + "' of the filter '" + name + "' is of another type.");
  }
  return {action, plugin, &filter.second};
}

void print_log(GLLogStream& log)
{
  QStringList lines;
  log.print(lines);
  for (const QString& line : lines) say(line.toStdString());
  log.clear();
}

/// \return the exit condition of the filter: empty, or why it did not work
std::string apply(const Step& step, MeshDocument& document, GLLogStream& log)
{
  QStringList missing;
  if (document.mm() && !step.plugin->isFilterApplicable(step.action, *document.mm(), missing))
    return "the mesh has no " + missing.join(", ").toStdString() + ".";
  RichParameterList parameters = step.plugin->initParameterList(step.action, document);
  for (const RichParameter& given : *step.given) parameters.setValue(given.name(), given.value());
  step.plugin->setLog(&log);
  if (document.mm()) document.mm()->updateDataMask(step.plugin->getRequirements(step.action));
  unsigned int changed = MeshModel::MM_UNKNOWN;
  try {
    step.plugin->applyFilter(step.action, parameters, document, changed, &show_progress);
  } catch (const std::exception& error) {
    return in_one_line(error.what());
  }
  return "";
}

/// What of the mesh a file can hold, as far as the mesh has it.
int saved_fields(const MeshModel& mesh, int capability, int format_defaults)
{
  constexpr std::pair<int, int> fields[] = {
      {MeshModel::MM_VERTCOLOR, Mask::IOM_VERTCOLOR},       {MeshModel::MM_VERTQUALITY, Mask::IOM_VERTQUALITY},
      {MeshModel::MM_VERTRADIUS, Mask::IOM_VERTRADIUS},     {MeshModel::MM_VERTTEXCOORD, Mask::IOM_VERTTEXCOORD},
      {MeshModel::MM_WEDGTEXCOORD, Mask::IOM_WEDGTEXCOORD}, {MeshModel::MM_FACECOLOR, Mask::IOM_FACECOLOR},
      {MeshModel::MM_FACEQUALITY, Mask::IOM_FACEQUALITY}};
  int mask = format_defaults & ~Mask::IOM_CAMERA;  // the camera is nobody's: there is no window
  for (const auto& [in_mesh, in_file] : fields) mask = mesh.hasDataMask(in_mesh) ? mask | in_file : mask & ~in_file;
  if (mesh.cm.en > 0) mask |= Mask::IOM_EDGEINDEX;
  if (mesh.cm.fn == 0) mask &= ~Mask::IOM_BITPOLYGONAL;  // the copy with polygons that is then saved has no edges
  return mask & capability;
}

/// All named attributes; MeshLab offers each as a switch whose name starts like this, and has them off.
RichParameterList save_parameters(const IOPlugin& format_plugin, const QString& format, const MeshModel& mesh,
                                  bool ascii)
{
  RichParameterList parameters = format_plugin.initSaveParameter(format, mesh);
  for (RichParameter& parameter : parameters) {
    if (parameter.name().startsWith("__CA_")) parameter.setValue(BoolValue(true));
    if (parameter.name() == "Binary") parameter.setValue(BoolValue(!ascii));
  }
  return parameters;
}

}  // namespace

struct Session::State {
  explicit State(char* program_name) : arguments{program_name, nullptr}, application(argument_count, arguments) {}
  int argument_count = 1;
  char* arguments[2];
  QApplication application;
  MeshDocument document;
  GLLogStream log;
};

Session::Session(char* program_name)
{
  qInstallMessageHandler(&drop_chatter);
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  state_ = std::make_unique<State>(program_name);
  std::setlocale(LC_ALL, "C");  // Qt has set the user's, whose decimal comma would change how files are read
}

Session::~Session() = default;

std::string Session::meshlab_version() { return meshlab::meshlabVersion(); }

void Session::load_own_plugins(const std::string& folder)
{
  const QDir plugins(folder.empty() ? folder_beside_library() : QString::fromStdString(folder));
  if (!plugins.exists())
    throw Failure(ExitStatus::plugin_not_loaded, "there is no folder " + plugins.path().toStdString() +
                                                     " with MeshLab's plugins; name it by --plugin-folder.");
  try {
    plugin_manager().loadPlugins(plugins);
  } catch (const MLException& error) {
    say("warning: " + in_one_line(error.what()));
  }
}

void Session::load_plugin(const std::string& file)
{
  try {
    plugin_manager().loadPlugin(QString::fromStdString(fs::absolute(file).string()));
  } catch (const std::exception& error) {
    throw Failure(ExitStatus::plugin_not_loaded, "the plugin was not loaded: " + in_one_line(error.what()));
  }
}

std::vector<std::string> Session::filter_names() const
{
  std::vector<std::string> names;
  for (FilterPlugin* plugin : plugin_manager().filterPluginIterator())
    for (QAction* action : plugin->actions()) names.push_back(plugin->filterName(action).toStdString());
  return names;
}

void Session::load_mesh(const std::string& file)
{
  if (!fs::is_regular_file(file)) throw Failure(ExitStatus::mesh_not_read, "there is no mesh file " + file + ".");
  try {
    meshlab::loadMeshWithStandardParameters(QString::fromStdString(fs::absolute(file).string()), state_->document,
                                            &show_progress);
  } catch (const std::exception& error) {
    throw Failure(ExitStatus::mesh_not_read, "cannot read the mesh " + file + ": " + in_one_line(error.what()));
  }
  const CMeshO& mesh = state_->document.mm()->cm;
  say(file + ": " + std::to_string(mesh.vn) + " vertices, " + std::to_string(mesh.fn) + " faces");
}

void Session::run_script(const std::string& file)
{
  FilterScript script;
  if (!fs::is_regular_file(file)) throw Failure(ExitStatus::script_not_usable, "there is no script " + file + ".");
  if (!script.open(QString::fromStdString(file)) || script.isEmpty())
    refuse_script(file, "this is no filter script, or it has no filter.");
  std::vector<Step> steps;
  for (const FilterNameParameterValuesPair& filter : script)
    steps.push_back(checked_step(file, filter, state_->document));
  for (const Step& step : steps) {
    const std::string name = step.plugin->filterName(step.action).toStdString();
    say("filter: " + name);
    const std::string failure = apply(step, state_->document, state_->log);
    print_log(state_->log);
    if (!failure.empty()) throw Failure(ExitStatus::filter_failed, "the filter '" + name + "' failed: " + failure);
  }
}

void Session::save_current_mesh(const std::string& file, bool ascii)
{
  const QString format = QFileInfo(QString::fromStdString(file)).suffix().toUpper();
  IOPlugin* plugin = plugin_manager().outputMeshPlugin(format);
  MeshModel* mesh = state_->document.mm();
  if (!plugin)
    throw Failure(ExitStatus::output_not_written,
                  "MeshLab cannot write a mesh in the format that " + file + " ends in.");
  if (!mesh) throw Failure(ExitStatus::output_not_written, "the filters left no mesh to save.");
  int capability = 0, defaults = 0;
  plugin->exportMaskCapability(format, capability, defaults);
  plugin->setLog(&state_->log);
  if (defaults & Mask::IOM_BITPOLYGONAL) mesh->updateDataMask(MeshModel::MM_FACEFACETOPO);  // what tells polygons apart
  std::string folder;  // of no interest to the user, but in MeshLab's sentence
  try {
    const SavedFiles saved(file);
    folder = saved.file().parent_path().string() + "/";
    plugin->save(format, QString::fromStdString(saved.file().string()), *mesh,
                 saved_fields(*mesh, capability, defaults), save_parameters(*plugin, format, *mesh, ascii),
                 &show_progress);
    saved.move_into_place();
  } catch (const std::exception& error) {
    const QString reason = QString(error.what()).remove(QString::fromStdString(folder));
    throw Failure(ExitStatus::output_not_written, "cannot write " + file + ": " + in_one_line(reason.toStdString()));
  }
  say("wrote " + file);
}

}  // namespace runner
