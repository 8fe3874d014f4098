// SPDX-License-Identifier: GPL-3.0-or-later
// The test models, where they are present.
#pragma once

#include <string>
#include <vector>

namespace test_support {

/// II_MODELS, or shared/models beside the project; it may be missing.
std::string models_folder();

/// Names (category/name, without .ply) of the models of a category, sorted; empty where the folder is missing.
std::vector<std::string> models_of(const std::string& category);

/// Path of a model's file; it may be missing.
std::string model_path(const std::string& name);

}  // namespace test_support
