# SPDX-License-Identifier: GPL-3.0-or-later
"""The vertices of a PLY file, with every property: VTK's reader keeps only the usual ones, and
Debian's meshio reads neither edges nor faces with further lists."""

import numpy as np

TYPES = {"char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2", "uint16": "u2",
         "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4", "float": "f4", "float32": "f4", "double": "f8", "float64": "f8"}
ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}


def tables(path):
    """The elements from the first on, by name, up to one with a list: arrays with a field a property."""
    with open(path, "rb") as file:
        order, elements = header(file, path)
        found = {}
        for name, count, fields in elements:
            if count and None in fields.values():
                break
            dtype = np.dtype([(field, order + kind) for field, kind in fields.items() if kind])
            found[name] = np.fromfile(file, dtype, count) if order else np.loadtxt(file, dtype, max_rows=count, ndmin=1)
    return found


def vertex_table(path):
    return tables(path)["vertex"]


def header(file, path):
    """Byte order, and (name, count, {property: type, None for a list}) of each element."""
    order, elements = None, []
    for line in file:
        words = line.decode("ascii", "replace").split()
        if words[:1] == ["format"]:
            order = ORDERS.get(words[1])
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), {}))
        elif words[:1] == ["property"]:
            elements[-1][2][words[-1]] = TYPES.get(words[1])
        elif words == ["end_header"]:
            break
    if order is None:
        raise ValueError(f"{path} is no PLY file")
    return order, elements
