// SPDX-License-Identifier: GPL-3.0-or-later
// Other estimators on the families, each at its best radius up to 40 ē.
#pragma once

#include <string>
#include <vector>

namespace accuracy {

/// accuracy family_peers [--seed N] [--cells TEXT] [--peers FILE]
///
/// Two tables in Markdown: our error over that of the best other estimator, each other one at the radius that is best
/// for that cell, by noise level or family, and one line a cell. The cells are white noise of 0.05 to 1 ē on meshes of
/// 41,000 vertices and a sample of the other families, all of the tuning half. What the others have said is kept in
/// FILE, so that only this library runs the next time. \throw std::invalid_argument
void run_family_peers(const std::vector<std::string>& argv);

}  // namespace accuracy
