#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""obj_to_ply.py MESH.obj MESH.ply: an OBJ file as PLY, vertices in the same order, with their colours, normals and texture
coordinates.

MeshLab 2020.09 cannot be given the OBJ itself: it takes the first vertex for none, drops its faces and aborts. Faces of more
than three corners are cut into triangles, by VTK where they may be concave.
"""

import os
import sys

import numpy as np


def statements(path):
    """Line number and words of each line; one that ends in a backslash goes on in the next."""
    before = ""
    with open(path, encoding="utf-8", errors="surrogateescape") as file:
        for number, line in enumerate(file, 1):
            line = before + line.rstrip("\r\n")
            if line.endswith("\\"):
                before = line[:-1] + " "
                continue
            before = ""
            words = line.split("#", 1)[0].split()
            if words:
                yield number, words


class Obj:
    """`lists`: the numbers of v, vt and vn; `corners`: a row of indices of these three for each corner of each face (-1: it
    has none); `sizes`: corners of each face."""

    def __init__(self, path):
        self.path, self.lists, self.corners, self.sizes = path, {"v": [], "vt": [], "vn": []}, [], []
        for number, (keyword, *words) in statements(path):
            try:
                if keyword in self.lists:
                    self.lists[keyword].append([float(word) for word in words])
                elif keyword == "f" and len(words) > 2:
                    self.corners += [self._corner(word.split("/")) for word in words]
                    self.sizes.append(len(words))
            except (ValueError, IndexError) as error:
                raise ValueError(f"the mesh file {path} is damaged in line {number}: {' '.join([keyword, *words])[:60]}") from error
        if not self.lists["v"]:
            raise ValueError(f"the mesh file {path} has no vertices: is it no OBJ file?")
        self.corners = np.array(self.corners, dtype=np.int64).reshape(-1, 3)

    def _corner(self, fields):
        """Indices begin with 1; negative ones count back from what was read last."""
        row = [-1, -1, -1]
        for i, (text, known) in enumerate(zip(fields, self.lists.values())):
            if text:
                row[i] = int(text) - 1 if int(text) > 0 else int(text) + len(known)
                if not 0 <= row[i] < (len(known) if i == 0 or int(text) < 0 else sys.maxsize):
                    raise IndexError(text)
        if row[0] < 0:
            raise ValueError("no vertex")
        return row

    def table(self, keyword, columns):
        """The numbers of v, vt or vn; where lines differ in length, as many columns as the shortest."""
        rows = self.lists[keyword]
        shortest = min((len(row) for row in rows), default=0)
        if rows and shortest < columns:
            raise ValueError(f"the mesh file {self.path} is damaged: a line '{keyword}' has less than {columns} numbers.")
        return np.array([row[:shortest] for row in rows]).reshape(len(rows), max(shortest, columns))


def triangles_of(sizes, points):
    """Rows of three corners: indices into the corners of all faces in a row, which lie at `points`."""
    if np.all(sizes == 3):
        return np.arange(3 * len(sizes)).reshape(-1, 3)
    import vtk  # takes a second, and most files need none of it
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
    cells, data, place = vtk.vtkCellArray(), vtk.vtkPolyData(), vtk.vtkPoints()
    cells.SetData(numpy_to_vtkIdTypeArray(np.concatenate([[0], np.cumsum(sizes)]), deep=True),
                  numpy_to_vtkIdTypeArray(np.arange(len(points)), deep=True))
    place.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(place)
    data.SetPolys(cells)
    cut = vtk.vtkTriangleFilter()
    cut.SetInputData(data)
    cut.Update()
    return vtk_to_numpy(cut.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)


def vertex_columns(obj):
    """Name, PLY type and values of each vertex property."""
    table = obj.table("v", 3)
    columns = [(axis, "double", table[:, i]) for i, axis in enumerate("xyz")]
    normals, corners = obj.table("vn", 3), obj.corners
    named = corners[:, 2] >= 0
    if len(normals) and named.any() and np.all(corners[named, 2] == corners[named, 0]):
        values = np.zeros((len(table), 3))
        values[:min(len(normals), len(table))] = normals[:len(table), :3]
        columns += [("n" + axis, "float", values[:, i]) for i, axis in enumerate("xyz")]
    if table.shape[1] >= 6:
        colours = table[:, 3:6] if table[:, 3:6].max() > 1 else 255 * table[:, 3:6]
        columns += [(name, "uchar", colours[:, i].clip(0, 255).round()) for i, name in enumerate(("red", "green", "blue"))]
    return columns


NUMPY = {"double": "<f8", "float": "<f4", "uchar": "u1"}


def write_ply(path, obj):
    columns = vertex_columns(obj)
    vertices = np.empty(len(columns[0][2]), dtype=[(name, NUMPY[kind]) for name, kind, _ in columns])
    for name, _, values in columns:
        vertices[name] = values
    corners = obj.corners
    points = np.column_stack([vertices[axis] for axis in "xyz"])[corners[:, 0]]
    triangles = triangles_of(np.array(obj.sizes, dtype=np.int64), points)
    fields = [("count", "u1"), ("vertex", "<i4", (3,))]
    textured = len(obj.lists["vt"]) > 0 and len(corners) > 0 and 0 <= corners[:, 1].min() and corners[:, 1].max() < len(obj.lists["vt"])
    if textured:
        fields += [("numbers", "u1"), ("texcoord", "<f4", (6,))]
    faces = np.empty(len(triangles), dtype=fields)
    faces["count"], faces["vertex"] = 3, corners[triangles, 0]
    if textured:
        faces["numbers"], faces["texcoord"] = 6, obj.table("vt", 2)[corners[triangles, 1], :2].reshape(-1, 6)
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}"]
    header += [f"property {kind} {name}" for name, kind, _ in columns]
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices"]
    header += ["property list uchar float texcoord"] * textured + ["end_header", ""]
    with open(path, "wb") as file:
        file.write("\n".join(header).encode() + vertices.tobytes() + faces.tobytes())


if __name__ == "__main__":
    try:
        write_ply(sys.argv[2], Obj(sys.argv[1]))
    except (ValueError, OSError) as error:
        sys.exit(str(error))
