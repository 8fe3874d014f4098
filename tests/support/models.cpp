// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/models.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace test_support {

std::string models_folder()
{
  const char* folder = std::getenv("II_MODELS");
  return folder ? folder : II_SOURCE_FOLDER "/../shared/models";
}

std::vector<std::string> models_of(const std::string& category)
{
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(models_folder() + "/" + category, missing))
    if (entry.path().extension() == ".ply") names.push_back(category + "/" + entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string model_path(const std::string& name) { return models_folder() + "/" + name + ".ply"; }

}  // namespace test_support
