// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing: the derivative of the curvature tensor, and where the surface is without its noise.
#pragma once

#include <array>
#include <vector>

#include "integral_invariant/features/curvature_field.h"

namespace integral_invariant {

/// A curvature field and how good it is, in normalised units (ē).
struct MeasuredField {
  CurvatureField curvature;
  std::vector<double> error;   ///< 1/ē; standard error of either curvature; all 0: not known
  std::vector<double> radius;  ///< ē; of the neighbourhood that each vertex's curvature comes from
};

/// The field of a run.
MeasuredField measured_field(const Result& result);

/// C = ∇II in a principal frame: C111, C112, C122, C222, where 1 is dir_max and 2 is dir_min.
using CurvatureDerivative = std::array<double, 4>;

/// C(t, t, t) of the tangent vector t = (x, y) in the principal frame.
inline double cubic_form(const CurvatureDerivative& c, double x, double y)
{
  return x * x * (x * c[0] + 3 * y * c[1]) + y * y * (3 * x * c[2] + y * c[3]);
}

/// One entry a vertex, in normalised units. The directions and the normal form a right-handed frame: dir_max × dir_min
/// = normal.
struct DifferentiatedField {
  CurvatureField curvature;                     ///< the local fits' values: smoother than the measured field
  std::vector<double> error;                    ///< 1/ē; standard error of either curvature
  std::vector<CurvatureDerivative> derivative;  ///< 1/ē²
  std::vector<double> derivative_error;         ///< 1/ē²; standard error of C(t, t, t) for a unit vector t
  std::vector<double> derivative_noise;         ///< 1/ē²; the part of it that noise makes, without bias
  std::vector<double> correlation;              ///< ē; over which errors of the curvature are alike
  std::vector<double> width;                    ///< ē; standard deviation of the weights of the local fits
  std::vector<Vec3> position;                   ///< ē; of the fitted surface: that of the mesh less its noise

  std::size_t size() const { return error.size(); }
};

/// At each vertex the tensors around it, turned into its tangent plane, are fitted by a linear function, with Gaussian
/// weights as wide as half the radius of the vertex's neighbourhood: over less, the field's errors are all alike, and
/// nothing averages out. The components of C come from the slopes with its symmetry imposed. The heights around it,
/// less the paraboloid of the tensor, are fitted likewise and place the vertex on the fitted surface. Where the error
/// of the field is not known, what the fits leave over is taken for it. Cost: O(n · width²). \throw Cancelled
DifferentiatedField differentiate(const Surface& surface, const MeasuredField& field, Execution& execution);

}  // namespace integral_invariant
