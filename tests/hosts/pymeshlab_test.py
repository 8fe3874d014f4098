# SPDX-License-Identifier: GPL-3.0-or-later
"""pymeshlab_test.py DOCUMENT PLUGIN MESH CORE: runs the document's Python example and compares its arrays with the core's."""

import contextlib
import re
import resource
import sys
import tempfile

import numpy as np

BATCH = 100
FILTER = "compute_curvature_by_integral_invariants_per_vertex"


def example(document):
    blocks = re.findall(r"```python\n(.*?)```", open(document, encoding="utf-8").read(), re.DOTALL)
    assert len(blocks) == 1, "the document must have one Python example"
    return blocks[0]


def check_arrays(found, core):
    kmax, kmin, radius, confidence, dirmax, dirmin = (core[:, 0], core[:, 1], core[:, 2], core[:, 3], core[:, 4:7], core[:, 7:])
    for name, expected in (("k_max", kmax), ("k_min", kmin), ("radius", radius), ("confidence", confidence),
                           ("dir_max", dirmax), ("dir_min", dirmin)):
        actual = found[name]
        assert actual.shape == expected.shape, (name, actual.shape)
        error = np.abs(actual - expected).max() / np.abs(expected).max()
        print(f"{name}: largest difference {error:.1e} of the largest value")
        assert error < 1e-9, name
    mesh = found["mesh"]
    assert np.array_equal(mesh.vertex_curvature_principal_dir1_matrix(), found["dir_max"])
    assert np.array_equal(mesh.vertex_curvature_principal_dir2_matrix(), found["dir_min"])
    assert np.abs(found["quality"] - kmax * kmin).max() < 1e-9 * np.abs(kmax * kmin).max()


def check_summary(summary, core):
    assert summary["vertices"] == len(core)
    assert summary["scales"] == 6
    assert 0 < summary["converged"] <= len(core)
    assert summary["low_confidence"] == 0
    assert summary["seconds"] > 0
    assert abs(summary["median_radius"] - np.median(core[:, 2])) < 1e-9
    assert abs(summary["maximal_max"] - core[:, 0].max()) < 1e-9 * abs(core[:, 0].max())
    assert abs(summary["gaussian_median"] - np.median(core[:, 0] * core[:, 1])) < 1e-9 * np.abs(core[:, 0]).max() ** 2


def check_refusals(found):
    import pymeshlab
    for parameters, sentence in (({"alpha": -1.0}, "'alpha' is -1"), ({"scales": 0}, "'scales' is 0")):
        try:
            found["meshes"].apply_filter(FILTER, **parameters)
        except pymeshlab.PyMeshLabException as error:
            assert sentence in str(error), str(error)
        else:
            raise AssertionError(f"{parameters} was not refused")


@contextlib.contextmanager
def files_no_larger_than(size):
    """As on a full disk: the export is refused when all is measured."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def check_batch_with_refusals(mesh_file):
    """A mesh set a file, every second of which is refused: before the first report of progress, or after the last."""
    import pymeshlab
    with tempfile.TemporaryDirectory() as folder:
        refused = ({"alpha": -1.0}, {"noise": 1e9}, {"export_file": "/no such folder/out.ply"}, {"export_file": f"{folder}/out.ply"})
        refusals, results = 0, set()
        for i in range(BATCH):
            meshes = pymeshlab.MeshSet()
            meshes.load_new_mesh(mesh_file)
            if i % 2:
                results.add(meshes.apply_filter(FILTER, scales=3)["maximal_max"])
                continue
            try:
                with files_no_larger_than(1000):
                    meshes.apply_filter(FILTER, **refused[i // 2 % len(refused)])
            except pymeshlab.PyMeshLabException:
                refusals += 1
    assert refusals == BATCH // 2, refusals
    assert len(results) == 1, results
    print(f"{BATCH} files in one batch, {refusals} of them refused")


def check_features(found):
    """The other filters: what they return is what the meshes then hold."""
    import pymeshlab
    meshes, surface = found["meshes"], found["meshes"].current_mesh_id()
    summary = meshes.apply_filter("select_ridges_and_valleys_by_curvature", high_percentile=90.0, low_percentile=80.0)
    assert summary["ridges"] > 0
    selected = meshes.current_mesh().vertex_selection_array()
    assert selected.sum() == summary["selected_vertices"] > 0
    kind = meshes.current_mesh().vertex_custom_scalar_attribute_array("ii_feature")
    assert np.array_equal(kind != 0, selected)

    summary = meshes.apply_filter("compute_multi_scale_integral_invariant_signature", scales=4)
    volumes = [meshes.current_mesh().vertex_custom_scalar_attribute_array(f"ii_volume_{i}")
               for i in range(1, summary["scales"] + 1)]
    assert len(volumes) == 4 and all(np.abs(volume).max() <= 1 for volume in volumes)

    layers = meshes.mesh_number()
    for name, parameters in (("create_crest_lines_layer", {}), ("create_principal_direction_layer", {"spacing": pymeshlab.PureValue(0.2)})):
        meshes.set_current_mesh(surface)
        summary = meshes.apply_filter(name, **parameters)
        layers += 1
        assert meshes.mesh_number() == layers, name
        lines = meshes.current_mesh()
        assert summary["lines"] > 0 and lines.edge_number() > 0 and lines.face_number() == 0, name
        assert lines.edge_matrix().max() < lines.vertex_number(), name
        print(f"{name}: {summary['lines']} lines, {lines.edge_number()} edges")


def main(document, plugin, mesh, core_file):
    core = np.fromfile(core_file).reshape(-1, 10)
    found = {}
    sys.argv = ["example", plugin, mesh]
    exec(compile(example(document), document, "exec"), found)  # pylint: disable=exec-used
    check_arrays(found, core)
    check_summary(found["summary"], core)
    check_refusals(found)
    check_features(found)
    check_batch_with_refusals(mesh)
    print("PyMeshLab and the core agree")


if __name__ == "__main__":
    main(*sys.argv[1:])
