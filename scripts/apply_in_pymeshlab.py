# SPDX-License-Identifier: GPL-3.0-or-later
"""apply_in_pymeshlab.py PLUGIN.so MESH PARAMETERS: runs of the filter in PyMeshLab, for scripts/matrix.

PARAMETERS is a JSON list of the runs' parameters. Prints a line "JSON {...}" for each run: its seconds, or its sentence.
"""

import json
import sys

import numpy as np
import pymeshlab

FILTER = "compute_curvature_by_integral_invariants_per_vertex"


def outcome(meshes, parameters):
    try:
        summary = meshes.apply_filter(FILTER, **parameters)
    except pymeshlab.PyMeshLabException as error:
        return {"sentence": str(error).strip().splitlines()[-1].removeprefix("Details: ")}
    mesh = meshes.current_mesh()
    arrays = [mesh.vertex_custom_scalar_attribute_array(name) for name in ("ii_kmax", "ii_kmin", "ii_radius", "ii_confidence")]
    arrays += [mesh.vertex_custom_point_attribute_matrix(name) for name in ("ii_dirmax", "ii_dirmin")]
    if not all(np.isfinite(array).all() for array in arrays):
        return {"failure": "not finite"}
    return {"seconds": summary["seconds"]}


def main(plugin, mesh, runs):
    pymeshlab.load_plugin(plugin)
    meshes = pymeshlab.MeshSet()
    try:
        meshes.load_new_mesh(mesh)
    except pymeshlab.PyMeshLabException as error:
        print("\n".join("JSON " + json.dumps({"sentence": str(error)}) for _ in runs))
        return
    for parameters in runs:
        print("JSON " + json.dumps(outcome(meshes, parameters)), flush=True)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], json.loads(sys.argv[3]))
