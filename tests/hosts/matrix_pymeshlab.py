# SPDX-License-Identifier: GPL-3.0-or-later
"""matrix_pymeshlab.py PLUGIN.so MESH RUNS: for matrix_test.py, by the Python that has PyMeshLab. RUNS is a JSON list of
parameters; prints a line "JSON ..." for each, its seconds or its sentence."""

import json
import sys

import numpy as np
import pymeshlab

SCALARS, VECTORS = ("ii_kmax", "ii_kmin", "ii_radius", "ii_confidence"), ("ii_dirmax", "ii_dirmin")


def apply_in_pymeshlab(plugin, mesh, runs):
    pymeshlab.load_plugin(plugin)
    for parameters in runs:
        meshes = pymeshlab.MeshSet()
        try:
            meshes.load_new_mesh(mesh)
            answer = meshes.apply_filter("compute_curvature_by_integral_invariants_per_vertex", **parameters)["seconds"]
            made = meshes.current_mesh()
            arrays = [made.vertex_custom_scalar_attribute_array(name) for name in SCALARS]
            arrays += [made.vertex_custom_point_attribute_matrix(name) for name in VECTORS]
            assert all(np.isfinite(array).all() for array in arrays), "not finite"
        except pymeshlab.PyMeshLabException as error:
            answer = str(error).strip().splitlines()[-1].removeprefix("Details: ")
        print("JSON " + json.dumps(answer), flush=True)


if __name__ == "__main__":
    apply_in_pymeshlab(sys.argv[1], sys.argv[2], json.loads(sys.argv[3]))
