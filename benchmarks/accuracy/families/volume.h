// SPDX-License-Identifier: GPL-3.0-or-later
// Scalar fields on grids, and marching cubes.
#pragma once

#include <array>
#include <random>
#include <vector>

#include "families/exact_shape.h"

namespace accuracy {

struct Volume {
  Vec3 origin, spacing;
  std::array<int, 3> size{};
  std::vector<double> value;  ///< x varies fastest; distances are in units of the smallest spacing

  double& at(int x, int y, int z) { return value[index(x, y, z)]; }
  double at(int x, int y, int z) const { return value[index(x, y, z)]; }
  Vec3 place(int x, int y, int z) const { return origin + Vec3{spacing.x * x, spacing.y * y, spacing.z * z}; }

 private:
  std::size_t index(int x, int y, int z) const
  {
    return std::size_t(x) + std::size_t(size[0]) * (std::size_t(y) + std::size_t(size[1]) * std::size_t(z));
  }
};

/// Signed distances to the surface, to first order, clamped at three voxels. The grid is shifted by a random fraction
/// of a voxel.
Volume sample(const ExactShape& shape, const Vec3& spacing, std::mt19937& generator);

/// Distances become −1 inside and +1 outside.
void make_binary(Volume& volume);
/// One pass of 1/4, 1/2, 1/4 along each axis: a variance of half a voxel squared.
void blur(Volume& volume);
void add_white(Volume& volume, double level, std::mt19937& generator);

/// The signed distance to an oriented cloud of points, as the Gaussian-weighted mean of the distances to their tangent
/// planes (implicit moving least squares) of width `width`; far from the cloud, the distance of `sign`.
Volume distance_to_points(const std::vector<Vec3>& points, const std::vector<Vec3>& normals, double width,
                          const Volume& sign);

/// The zero set by VCG's marching cubes with linear interpolation along the grid's edges, oriented towards larger
/// values.
TriangleMesh marching_cubes(const Volume& volume);

}  // namespace accuracy
