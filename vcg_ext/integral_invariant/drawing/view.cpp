// SPDX-License-Identifier: GPL-3.0-or-later
// Views.
#include "integral_invariant/drawing/view.h"

#include "integral_invariant/error.h"

namespace integral_invariant {

View make_view(const std::string& name, const Vec3& toward, const Vec3& up)
{
  const double size = norm(toward), height = norm(up);
  if (!(size > 0) || !std::isfinite(size) || !(height > 0) || !std::isfinite(height))
    throw ParameterError("The view's direction and its up vector must be finite and not zero.");
  constexpr double least_sine = 1e-6;
  const Vec3 right = cross(up * (1 / height), toward * (1 / size));
  if (!(norm(right) > least_sine))
    throw ParameterError("The view's up vector is parallel to its direction; choose another 'up'.");
  View view{name, normalized(right), {}, normalized(toward)};
  view.up = cross(view.toward, view.right);
  return view;
}

View side_view(Side side)
{
  switch (side) {
    case Side::front:
      return make_view("front", {0, 0, 1}, {0, 1, 0});
    case Side::back:
      return make_view("back", {0, 0, -1}, {0, 1, 0});
    case Side::left:
      return make_view("left", {-1, 0, 0}, {0, 1, 0});
    case Side::right:
      return make_view("right", {1, 0, 0}, {0, 1, 0});
    case Side::top:
      return make_view("top", {0, 1, 0}, {0, 0, -1});
    case Side::bottom:
      return make_view("bottom", {0, -1, 0}, {0, 0, 1});
  }
  throw ParameterError("There is no such side.");
}

}  // namespace integral_invariant
