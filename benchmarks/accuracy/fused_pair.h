// SPDX-License-Identifier: GPL-3.0-or-later
// A bumpy sphere and a copy 8 times its size, joined by a neck into one connected surface.
#pragma once

#include <functional>

#include "truth.h"

namespace accuracy {

/// Both parts are the star-shaped surface `radius` (of about 1, round near the poles) around its centre, the large one
/// scaled by 8, meshed irregularly with the same edge length: `vertices` on the small part. The neck is C¹ and has no
/// truth: it is not judged, nor is what lies within five edges of it. Errors are relative to the curvatures of a
/// vertex's own part, and as many vertices are judged on either.
TruthMesh fused_pair(const std::function<double(const Vec3&)>& radius, int vertices, std::size_t judged);

}  // namespace accuracy
