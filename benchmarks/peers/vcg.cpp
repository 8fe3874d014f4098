// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/vcg_mesh.h"

#include <vcg/complex/algorithms/update/curvature_fitting.h>

#include <cmath>

#include "peers/peers.h"

namespace peers {

namespace {

using Fitting = vcg::tri::UpdateCurvatureFitting<VcgMesh>;

double mean_curvature(const VcgMesh& m)
{
  double sum = 0;
  for (const VcgVertex& v : m.vert) sum += std::fabs(v.cK1());
  return sum / double(m.vert.size());
}

}  // namespace

double vcg_quadric(const integral_invariant::TriangleMesh& mesh)
{
  VcgMesh m;
  fill(m, mesh);
  Fitting::computeCurvature(m);
  return mean_curvature(m);
}

double vcg_scale_dependent_quadric(const integral_invariant::TriangleMesh& mesh, double radius)
{
  VcgMesh m;
  fill(m, mesh);
  Fitting::updateCurvatureLocal(m, float(radius));
  return mean_curvature(m);
}

}  // namespace peers
