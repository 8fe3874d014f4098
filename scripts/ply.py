# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads PLY files into numpy arrays, with every property that they have: VTK's own reader keeps only the usual ones."""

import numpy as np

_TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4", "float": "f4", "double": "f8",
    "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4", "float32": "f4",
    "float64": "f8",
}


def read_ply(path):
    """Returns (vertices, triangles): a dict from property name to an array of n, and an m × 3 array of indices."""
    elements = read_elements(path)
    faces = elements.get("face", {})
    triangles = next((c for key, c in faces.items() if key in ("vertex_indices", "vertex_index")), None)
    return elements.get("vertex", {}), np.zeros((0, 3), dtype=np.int64) if triangles is None else triangles


def read_edges(path):
    """An array of k × 2 indices; k is 0 where the file has no edges."""
    edges = read_elements(path).get("edge")
    return np.zeros((0, 2), dtype=np.int64) if edges is None else np.column_stack([edges["vertex1"], edges["vertex2"]])


def read_elements(path):
    """All elements by name, each a dict from property name to an array."""
    with open(path, "rb") as file:
        byte_order, elements = _read_header(file, path)
        body = file.read()
    reader = _AsciiBody(body) if byte_order is None else _BinaryBody(body, byte_order)
    return {name: reader.read(count, properties) for name, count, properties in elements}


def _read_header(file, path):
    if file.readline().strip() != b"ply":
        raise ValueError(f"{path} is not a PLY file")
    byte_order, elements = None, []
    for line in file:
        words = line.decode("ascii", "replace").split()
        if not words or words[0] in ("comment", "obj_info"):
            continue
        if words[0] == "format":
            byte_order = {"ascii": None, "binary_little_endian": "<", "binary_big_endian": ">"}[words[1]]
        elif words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append((words[-1], [_TYPES[w] for w in words[1:-1] if w != "list"], words[1] == "list"))
        elif words[0] == "end_header":
            return byte_order, elements
    raise ValueError(f"{path}: the header has no end")


class _BinaryBody:
    """Elements one after the other; lists must all have three entries, so that a row has a fixed size."""

    def __init__(self, body, byte_order):
        self._body, self._order, self._offset = body, byte_order, 0

    def read(self, count, properties):
        fields = []
        for name, types, is_list in properties:
            if is_list:
                fields.append((name + " size", self._order + types[0]))
                length = self._list_length(types[0], fields, count)
                fields.append((name, self._order + types[1], (length,)))
            else:
                fields.append((name, self._order + types[0]))
        dtype = np.dtype(fields)
        rows = np.frombuffer(self._body, dtype, count, self._offset)
        self._offset += count * dtype.itemsize
        for name, _, is_list in properties:
            if is_list and count and np.any(rows[name + " size"] != rows[name + " size"][0]):
                raise ValueError("the faces are not all triangles")
        return {name: rows[name].astype(np.int64 if is_list else rows[name].dtype.newbyteorder("="))
                for name, _, is_list in properties}

    def _list_length(self, kind, fields, count):
        if count == 0:
            return 3
        before = np.dtype(fields[:-1]).itemsize if len(fields) > 1 else 0
        return int(np.frombuffer(self._body, self._order + kind, 1, self._offset + before)[0])


class _AsciiBody:
    def __init__(self, body):
        self._lines = iter(body.splitlines())

    def read(self, count, properties):
        rows = [next(self._lines).split() for _ in range(count)]
        if len(properties) == 1 and properties[0][2]:
            return {properties[0][0]: np.array([row[1:4] for row in rows], dtype=np.int64).reshape(-1, 3)}
        if any(is_list for _, _, is_list in properties):
            raise ValueError("faces with further properties are read from binary files only")
        table = np.array(rows, dtype=np.float64)
        return {name: table[:, i] for i, (name, _, _) in enumerate(properties)}
