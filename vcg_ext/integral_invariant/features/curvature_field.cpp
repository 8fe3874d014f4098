// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature fields for the feature stages, and their smoothing over the mesh.
#include "integral_invariant/features/curvature_field.h"

#include "integral_invariant/ball_curvature/curvature_tensor.h"

namespace integral_invariant {

namespace {

std::vector<Symmetric3> tensors_of(const CurvatureField& field, Execution& execution)
{
  std::vector<Symmetric3> tensors;
  resize_in_steps(tensors, field.size(), execution);
  for_each_index(field.size(), execution, [&](std::size_t v) {
    tensors[v] = outer(field.dir_max[v]) * field.kappa_max[v] + outer(field.dir_min[v]) * field.kappa_min[v];
  });
  return tensors;
}

}  // namespace

CurvatureField curvature_field(const Result& result)
{
  CurvatureField field{result.kappa_max, result.kappa_min, result.dir_max, result.dir_min, result.normal};
  for (double& k : field.kappa_max) k *= result.average_edge;
  for (double& k : field.kappa_min) k *= result.average_edge;
  return field;
}

CurvatureField smoothed(const Surface& surface, CurvatureField field, int passes, Execution& execution, double to)
{
  const auto &start = surface.neighbour_start(), &neighbours = surface.neighbours();
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<Symmetric3> tensors = tensors_of(field, execution);
    CurvatureField next = field;
    execution.check();
    parallel_for(
        field.size(), 2048, execution,
        [&](std::size_t begin, std::size_t end, int) {
          for (std::size_t v = begin; v < end; ++v) {
            Symmetric3 tensor = tensors[v];
            Vec3 normal = field.normal[v];
            for (std::uint32_t e = start[v]; e < start[v + 1]; ++e) {
              tensor += tensors[neighbours[e]];
              normal += field.normal[neighbours[e]];
            }
            const double share = 1 / double(1 + start[v + 1] - start[v]);
            const PrincipalCurvatures k =
                principal_curvatures({tensor * share, normalized(normal, field.normal[v]), 1});
            next.kappa_max[v] = k.kappa_max;
            next.kappa_min[v] = k.kappa_min;
            next.dir_max[v] = k.dir_max;
            next.dir_min[v] = k.dir_min;
            next.normal[v] = normalized(normal, field.normal[v]);
          }
        },
        to * pass / passes, to * (pass + 1) / passes);
    field = std::move(next);
  }
  return field;
}

}  // namespace integral_invariant
