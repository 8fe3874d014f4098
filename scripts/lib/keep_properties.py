#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""keep_properties.py MESH.ply RESULT.ply OUT.ply: the user's file as it is, with the results of the filter added.

MeshLab 2020.09 reads coordinates in single precision, only the properties that it knows, and polygons as triangles; what
it saves has lost the rest. Here every element, property, type and comment of MESH stays, and its vertices get the
properties of RESULT that the filter measured. What a result takes the name of stays as original_NAME, but for results of
an earlier run. Where that cannot be, OUT is RESULT itself, and the reason is printed.
"""

import re
import shutil
import sys

import numpy as np

TYPES = {"char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2", "uint16": "u2",
         "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4", "float": "f4", "float32": "f4", "double": "f8", "float64": "f8"}
COLOURS = ("red", "green", "blue", "alpha")


class NotMergeable(Exception):
    pass


class PlyVertices:
    """A PLY file whose vertices are a table; what is before and after them in the file stays bytes."""

    def __init__(self, path):
        with open(path, "rb") as file:
            content = file.read()
        end = re.search(rb"^end_header[ \t]*\r?\n", content, re.MULTILINE)
        if not content.startswith(b"ply") or not end:
            raise NotMergeable("its header has no end")
        self.header = content[:end.start()].decode("latin-1").splitlines()
        self.order = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}[self._words("format")[0][1]]
        self._read_table(content[end.end():])

    def _words(self, keyword):
        return [line.split() for line in self.header if line.split()[:1] == [keyword]]

    def _read_table(self, body):
        elements = self._words("element")
        if not elements or elements[0][1] != "vertex":
            raise NotMergeable("its vertices do not come first")
        count = int(elements[0][2])
        self.first = next(i for i, line in enumerate(self.header) if line.split()[:2] == ["element", "vertex"]) + 1
        self.last = next((i for i, line in enumerate(self.header) if i >= self.first and line.startswith("element")), len(self.header))
        fields = [line.split()[1:] for line in self.header[self.first:self.last] if line.startswith("property")]
        if any(field[0] == "list" for field in fields):
            raise NotMergeable("its vertices have lists")
        self.fields = [(name, kind) for kind, name in fields]
        if self.order:
            dtype = np.dtype([(name, self.order + TYPES[kind]) for name, kind in self.fields])
            self.table = np.frombuffer(body, dtype, count)
            self.rest = body[self.table.nbytes:]
        else:
            lines = body.decode("latin-1").split("\n")
            columns = np.array([line.split() for line in lines[:count]], dtype=object).reshape(count, len(fields))
            self.table = {name: columns[:, i] for i, (name, _) in enumerate(self.fields)}
            self.rest = "\n".join(lines[count:]).encode("latin-1")
        self.count = count


def result_names(mesh, result):
    """Colours are a result unless the filter was asked for none and those of the mesh came through."""
    own = [name for name, _ in mesh.fields]
    names = [name for name, _ in result.fields]
    coloured = "original_red" in names or "red" not in own
    return [n for n in names if n.startswith(("ii_", "scalar_ii_")) or n == "quality" or (coloured and n in COLOURS)]


def kept_fields(mesh, results):
    """(name in the file, name in MESH, type) of what stays. The colours and quality beside earlier results are theirs."""
    measured_before = any(name.startswith("ii_") for name, _ in mesh.fields)
    return [("original_" + name if name in results else name, name, kind) for name, kind in mesh.fields
            if not (name in results and measured_before)]


def merged(mesh, result):
    results = result_names(mesh, result)
    kinds = dict(result.fields)
    kept = kept_fields(mesh, results)
    header = [f"property {kind} {new}" for new, _, kind in kept] + [f"property {kinds[name]} {name}" for name in results]
    lines = mesh.header[:mesh.first] + header + mesh.header[mesh.last:]
    if mesh.order:
        columns = [(new, mesh.table[name], kind) for new, name, kind in kept] + [(name, result.table[name], kinds[name]) for name in results]
        rows = np.empty(mesh.count, [(name, mesh.order + TYPES[kind]) for name, _, kind in columns])
        for name, values, _ in columns:
            rows[name] = values
        body = rows.tobytes()
    else:
        columns = [mesh.table[name] for _, name, _ in kept] + [[f"{v:.9g}" for v in result.table[name]] for name in results]
        body = "".join(" ".join(row) + "\n" for row in zip(*columns)).encode("latin-1")
    return ("\n".join(lines) + "\nend_header\n").encode("latin-1") + body + mesh.rest


def same_places(mesh, result):
    """To single precision, which is what MeshLab has read."""
    if mesh.count != result.count:
        return False
    return all(np.array_equal(np.asarray(mesh.table[axis], float).astype("f4"), np.asarray(result.table[axis], float).astype("f4"),
                              equal_nan=True) for axis in "xyz")


def main(mesh_file, result_file, out_file):
    try:
        mesh, result = PlyVertices(mesh_file), PlyVertices(result_file)
        if not same_places(mesh, result):
            raise NotMergeable("MeshLab has changed its vertices")
        content = merged(mesh, result)
    except (NotMergeable, KeyError, ValueError) as reason:
        print(reason)
        shutil.copyfile(result_file, out_file)
        return
    with open(out_file, "wb") as file:
        file.write(content)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except OSError as error:  # of a write or of the close
        sys.exit(error.strerror)
