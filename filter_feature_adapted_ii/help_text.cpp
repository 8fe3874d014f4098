// SPDX-License-Identifier: GPL-3.0-or-later
// What MeshLab shows above the parameters.
#include "help_text.h"

namespace integral_invariant::filter {

const char* const help_text = R"(Measures principal curvatures and their directions by <b>integrals instead of
derivatives</b>: from the moments of the part of the solid that lies inside a ball around each vertex. Integrals average
noise away, and the radius of the ball says which detail counts. The moments come from FFTs on a voxel grid (closed
meshes) or from sums over the triangles (open ones too).<br/>
<b>Feature-adapted</b> radii: the moments are computed at several scales; starting from the median over the scales, the
radius <i>r</i> of each vertex moves step by step towards alpha / max(|k<sub>max</sub>|, |k<sub>min</sub>|) and is then
smoothed over the surface without blurring the borders of features. Fine detail ends with small balls, flat parts with
large ones.<br/>
<b>Conventions:</b> k<sub>max</sub> &ge; k<sub>min</sub> in 1/length, positive where the solid is convex (a sphere of radius
R has +1/R); faces point outward. k<sub>max</sub> = 6/(&pi;r<sup>6</sup>) (&lambda;<sub>1</sub> &minus; 3&lambda;<sub>2</sub>)
+ 8/(5r) with &lambda;<sub>1</sub> &ge; &lambda;<sub>2</sub> the tangential eigenvalues of the covariance of the solid in the
ball; exchange them for k<sub>min</sub>.<br/>
<b>Results:</b> quality and colour, radius, curvature directions (seen with <i>Show Curvature</i>), and the vertex
attributes ii_kmax, ii_kmin, ii_radius, ii_confidence (the part of the ball's surface that was really there), ii_dirmax,
ii_dirmin. Nothing is moved, removed or renumbered.<br/>
See: <i>Y.-K. Lai, S.-M. Hu, T. Fang</i>, <b>"Robust Principal Curvatures using Feature Adapted Integral Invariants"</b>,
<a href="https://doi.org/10.1145/1629255.1629298">SPM 2009</a>;
<i>Y.-L. Yang, Y.-K. Lai, S.-M. Hu, H. Pottmann</i>, <b>"Robust Principal Curvatures on Multiple Scales"</b>,
<a href="https://doi.org/10.2312/SGP/SGP06/223-226">SGP 2006</a>;
<i>H. Pottmann, J. Wallner, Y.-L. Yang, Y.-K. Lai, S.-M. Hu</i>, <b>"Principal curvatures from the integral invariant
viewpoint"</b>, <a href="https://doi.org/10.1016/j.cagd.2007.07.004">CAGD 24, 2007</a>.)";

}  // namespace integral_invariant::filter
