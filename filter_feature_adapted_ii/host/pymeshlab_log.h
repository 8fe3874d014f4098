// SPDX-License-Identifier: GPL-3.0-or-later
// A fault of PyMeshLab, and what keeps a batch alive in spite of it.
#pragma once

namespace integral_invariant::filter {

/// To be called before a filter fails. PyMeshLab (up to 2025.7 at least) keeps a pointer to the log of the mesh set
/// while a filter runs, and forgets it only where the filter ends well. After a failure it writes the progress of the
/// next load_new_mesh() there, which ends in a MemoryError or a crash when that mesh set is gone (PyMeshLab#384). Any
/// filter that ends well makes it forget: this runs one on a mesh set of its own. Does nothing outside PyMeshLab.
void make_pymeshlab_forget_its_log() noexcept;

}  // namespace integral_invariant::filter
