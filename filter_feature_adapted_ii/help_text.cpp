// SPDX-License-Identifier: GPL-3.0-or-later
// What MeshLab shows above the parameters.
#include "help_text.h"

namespace integral_invariant::filter {

const char* const help_text = R"(
<p>Measures the principal curvatures and their directions by <b>integrals instead of derivatives</b>: around every vertex
it takes the part of the solid that lies inside a ball, and reads the curvatures from the moments of that part. Integrals
average noise away where derivatives amplify it, and the radius of the ball says which detail counts: what is
smaller than the ball is smoothed over, what is larger is measured. Each radius needs one set of moments; they come either
from convolutions on a voxel grid by FFT (closed meshes), or from sums over the triangles (open meshes too).</p>
<p>One radius rarely suits a whole model. With <b>feature-adapted</b> radii the moments are computed at several scales, and
every vertex gets the ball that fits its feature: starting from the median over the scales, the radius <i>r</i> moves step
by step towards <i>alpha</i> / max(|k<sub>max</sub>|, |k<sub>min</sub>|), is then smoothed over the surface without
blurring the borders of features, and gives the final curvatures. Fine detail ends with small balls, flat parts with
large ones.</p>
<p><b>Conventions.</b> k<sub>max</sub> &ge; k<sub>min</sub>, with sign: positive where the solid is convex, so a sphere of
radius R has +1/R everywhere. Units are 1/length. The mesh must be oriented with its faces outward; one that is
inside out is recognised and measured as if flipped. With &lambda;<sub>1</sub> &ge; &lambda;<sub>2</sub> the tangential
eigenvalues of the covariance of the solid inside the ball,
k<sub>max</sub> = 6/(&pi;r<sup>6</sup>) (&lambda;<sub>1</sub> &minus; 3&lambda;<sub>2</sub>) + 8/(5r) and
k<sub>min</sub> = 6/(&pi;r<sup>6</sup>) (&lambda;<sub>2</sub> &minus; 3&lambda;<sub>1</sub>) + 8/(5r).</p>
<p><b>Results.</b> Vertex quality and colour (the chosen quantity), vertex radius, curvature directions (to be seen with
<i>Show Curvature</i>), and the named vertex attributes <i>ii_kmax, ii_kmin, ii_radius, ii_confidence</i> (scalars) and
<i>ii_dirmax, ii_dirmin</i> (unit vectors). <i>ii_confidence</i>, from 0 to 1, is the part of the ball's surface that was
really there. Vertices and faces are neither moved nor removed nor renumbered.</p>
<p>See:<br/>
<i>Y.-K. Lai, S.-M. Hu, T. Fang</i><br/>
<b>"Robust Principal Curvatures using Feature Adapted Integral Invariants"</b><br/>
SIAM/ACM Joint Conference on Geometric and Physical Modeling, 2009, <a href="https://doi.org/10.1145/1629255.1629298">doi:10.1145/1629255.1629298</a><br/>
<i>Y.-L. Yang, Y.-K. Lai, S.-M. Hu, H. Pottmann</i><br/>
<b>"Robust Principal Curvatures on Multiple Scales"</b><br/>
Symposium on Geometry Processing, 2006, <a href="https://doi.org/10.2312/SGP/SGP06/223-226">doi:10.2312/SGP/SGP06/223-226</a><br/>
<i>H. Pottmann, J. Wallner, Y.-L. Yang, Y.-K. Lai, S.-M. Hu</i><br/>
<b>"Principal curvatures from the integral invariant viewpoint"</b><br/>
Computer Aided Geometric Design 24, 2007, <a href="https://doi.org/10.1016/j.cagd.2007.07.004">doi:10.1016/j.cagd.2007.07.004</a></p>
)";

}  // namespace integral_invariant::filter
