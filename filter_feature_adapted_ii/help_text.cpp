// SPDX-License-Identifier: GPL-3.0-or-later
// What MeshLab shows above the parameters.
#include "help_text.h"

namespace integral_invariant::filter {

const char* const help_text =
    R"(Principal curvatures and directions by <b>integrals instead of derivatives</b>: from the
covariance of the part of the solid inside a ball around each vertex. Integrals average noise away; the radius of the ball says
which detail counts. A <b>statistical</b> radius (the default) measures at balls of all sizes, weighs each by what it shows over
the mesh's own noise, removes the bias of large balls, and gives the standard error ii_error.<br/>
The published <b>feature-adapted</b> radius (with the published estimator): from the median over the scales, the radius <i>r</i>
of each vertex moves step by step towards alpha / max(|k<sub>max</sub>|, |k<sub>min</sub>|), and is then smoothed over the surface.
k<sub>max</sub> = 6/(&pi;r<sup>6</sup>) (&lambda;<sub>1</sub> &minus; 3&lambda;<sub>2</sub>) + 8/(5r), &lambda;<sub>1</sub> &ge;
&lambda;<sub>2</sub> the tangential eigenvalues of the covariance; exchange them for k<sub>min</sub>. <b>Signs:</b> k<sub>max</sub>
&ge; k<sub>min</sub> in 1/length, positive where the solid is convex; faces point outward.<br/>
See: <i>Lai, Hu, Fang</i>, <b>"Robust Principal Curvatures using Feature Adapted Integral Invariants"</b>,
<a href="https://doi.org/10.1145/1629255.1629298">GPM 2009</a>;
<i>Yang, Lai, Hu, Pottmann</i>, <b>"Robust Principal Curvatures on Multiple Scales"</b>,
<a href="https://doi.org/10.2312/SGP/SGP06/223-226">SGP 2006</a>;
<i>Pottmann, Wallner, Yang, Lai, Hu</i>, <b>"Principal curvatures from the integral invariant viewpoint"</b>,
<a href="https://doi.org/10.1016/j.cagd.2007.07.004">CAGD 24, 2007</a>.)";

const char* const ridge_valley_help = R"(Selects the regions of the surface that bend strongly: <b>ridges</b>, where the
maximal curvature is large and positive, and <b>valleys</b>, where the minimal curvature is large and negative. The curvatures
are those of <i>Compute Curvature by Integral Invariants per Vertex</i>, so noise does not break the regions up.<br/>
With two thresholds a region grows, over connected vertices above the low one, from vertices above the high one; small regions
are dropped. Selects vertices and faces, and writes the vertex attribute ii_feature (1 ridge, -1 valley, 0 neither).<br/>
See: <i>Y.-K. Lai, S.-M. Hu, T. Fang</i>, <b>"Robust Principal Curvatures using Feature Adapted Integral Invariants"</b>,
<a href="https://doi.org/10.1145/1629255.1629298">SPM 2009</a>, section 5.)";

const char* const crest_line_help =
    R"(Makes a new layer of <b>crest lines</b> as edges: ridge lines, along which the maximal
curvature is largest across the line, and valley lines, the same of the minimal curvature. They are found on the curvatures of
<i>Compute Curvature by Integral Invariants per Vertex</i>, as zeros of the derivative along the principal direction.<br/>
The quality of a line's vertices is its <b>strength</b>, the integral of the curvature along it: a number without unit, so the
same filter fits a model in any unit. Attributes of the new layer: ii_line (number of the line, strongest first), ii_kind
(1 ridge, -1 valley), ii_strength. To keep the edges in a file, name one in export_file.)";

const char* const direction_help =
    R"(Makes a new layer that shows the <b>principal directions</b>: evenly spaced lines of
curvature over the surface, or short segments at vertices. The directions are those of
<i>Compute Curvature by Integral Invariants per Vertex</i>. Lines end at umbilics (where the surface bends alike in all
directions), at boundaries, and where they come too near to another line; closed ones are joined.<br/>
Attributes of the new layer: ii_line (number of the line), ii_kind (1 maximal, -1 minimal curvature), ii_strength (the
curvature along the line). To keep the edges in a file, name one in export_file.)";

const char* const signature_help =
    R"(Computes integral invariants of every vertex at <b>all scales</b>: the volume invariant
1 &minus; 2V / (4/3 &pi;r<sup>3</sup>), V the solid's part of the ball, which runs from &minus;1 (all solid) over 0 (flat) to 1
(nothing solid), and the mean and the difference of the principal curvatures. They are stored as vertex attributes ii_volume_1,
ii_mean_1, ii_difference_1 and so on from the smallest scale, and one number made of a quantity's scales becomes
the quality: the value at one scale, the minimum, the maximum, or the p-norm. Faint relief, such as worn inscriptions, shows at
scales of its own depth.<br/>
See: <i>H. Pottmann, J. Wallner, Y.-L. Yang, Y.-K. Lai, S.-M. Hu</i>, <b>"Principal curvatures from the integral invariant
viewpoint"</b>, <a href="https://doi.org/10.1016/j.cagd.2007.07.004">CAGD 24, 2007</a>.)";

}  // namespace integral_invariant::filter
