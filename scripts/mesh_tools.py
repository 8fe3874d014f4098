#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small jobs on meshes for the figures: average edge length, noise, simplification. PLY files in and out."""

import argparse
import sys

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

from ply import read_ply


def load(path):
    vertices, triangles = read_ply(path)
    return np.column_stack([vertices[axis] for axis in "xyz"]).astype(float), triangles


def average_edge(points, triangles):
    edges = np.sort(np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    edges = np.unique(edges, axis=0)
    return np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1).mean()


def vertex_normals(points, triangles):
    areas = np.cross(points[triangles[:, 1]] - points[triangles[:, 0]], points[triangles[:, 2]] - points[triangles[:, 0]])
    normals = np.zeros_like(points)
    for corner in range(3):
        np.add.at(normals, triangles[:, corner], areas)
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)


def save(path, points, triangles):
    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty float x\nproperty float y\n"
              f"property float z\nelement face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n")
    faces = np.empty(len(triangles), dtype=[("count", "u1"), ("index", "<i4", (3,))])
    faces["count"], faces["index"] = 3, triangles
    with open(path, "wb") as file:
        file.write(header.encode() + points.astype("<f4").tobytes() + faces.tobytes())


def with_noise(points, triangles, sigma):
    """Gaussian, along the normals, the same on every run."""
    shift = np.random.default_rng(1).normal(0, sigma * average_edge(points, triangles), len(points))
    return points + vertex_normals(points, triangles) * shift[:, None]


def simplified(points, triangles, count):
    data = vtk.vtkPolyData()
    vtk_points = vtk.vtkPoints()
    vtk_points.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(vtk_points)
    cells = np.hstack([np.full((len(triangles), 1), 3), triangles]).astype(np.int64)
    polys = vtk.vtkCellArray()
    polys.SetCells(len(triangles), numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells.ravel()), deep=True))
    data.SetPolys(polys)
    decimation = vtk.vtkQuadricDecimation()
    decimation.SetInputData(data)
    decimation.SetTargetReduction(1 - count / len(triangles))
    decimation.Update()
    result = decimation.GetOutput()
    faces = vtk_to_numpy(result.GetPolys().GetData()).reshape(-1, 4)[:, 1:]
    used, faces = np.unique(faces, return_inverse=True)
    return vtk_to_numpy(result.GetPoints().GetData())[used], faces.reshape(-1, 3)


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__)
    jobs = parser.add_subparsers(dest="job", required=True)
    job = jobs.add_parser("edge", help="print FACTOR average edge lengths")
    job.add_argument("mesh")
    job.add_argument("factor", type=float)
    job = jobs.add_parser("noise", help="move the vertices along their normals by SIGMA average edge lengths")
    job.add_argument("mesh")
    job.add_argument("sigma", type=float)
    job.add_argument("output")
    job = jobs.add_parser("simplify", help="keep about COUNT triangles")
    job.add_argument("mesh")
    job.add_argument("count", type=int)
    job.add_argument("output")
    options = parser.parse_args(argv)
    points, triangles = load(options.mesh)
    if options.job == "edge":
        print(f"{options.factor * average_edge(points, triangles):.6g}")
    elif options.job == "noise":
        save(options.output, with_noise(points, triangles, options.sigma), triangles)
    else:
        save(options.output, *simplified(points, triangles, options.count))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
