#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of [Lai09] for scripts/figures: the meshes they need, and the pictures from the runs that it made."""

import argparse
import pathlib

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import pictures as pic
from exported import tables

PANEL = (440, 540)
TITLE_HEIGHT, LEGEND_WIDTH, FONT = 34, 150, 0.028
RIDGE, VALLEY, NEUTRAL = (0.77, 0.13, 0.17), (0.13, 0.33, 0.75), (0.82, 0.82, 0.81)
RADII = ("small", "large", "adapted", "statistical")
TITLES = ("fixed, 2 edges", "fixed, 8 edges", "adapted, 2 to 8 edges", "default of this plugin")
ARMADILLO, LUCY = {"view": "180,5", "up": "y"}, {"view": "180,5", "up": "z"}
FACE = {**ARMADILLO, "focus": (0.5, 0.84, 0.30)}
BUDDHA = {"view": "0,5", "up": "y"}
BUDDHA_FACE = {**BUDDHA, "focus": (0.5, 0.84, 0.28)}


def read_geometry(path):
    reader = vtk.vtkPLYReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def average_edge(data):
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    edges = np.unique(np.sort(np.vstack([triangles[:, [i, i - 1]] for i in range(3)]), axis=1), axis=0)
    return np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1).mean()


def write_noisy(data, sigma, path):
    """Gaussian along the normals, of that many average edges; the same on every run."""
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.Update()
    data = normals.GetOutput()
    points = vtk_to_numpy(data.GetPoints().GetData())
    shift = np.random.default_rng(1).normal(0, sigma * average_edge(data), len(points))
    moved = points + vtk_to_numpy(data.GetPointData().GetNormals()) * shift[:, None]
    data.GetPoints().SetData(numpy_to_vtk(moved.astype(np.float32), deep=True))
    write_geometry(data, path)


def write_simplified(data, count, path):
    decimation, cleaned = vtk.vtkQuadricDecimation(), vtk.vtkCleanPolyData()
    decimation.SetInputData(data)
    decimation.SetTargetReduction(max(0.0, 1 - count / data.GetNumberOfPolys()))
    cleaned.SetInputConnection(decimation.GetOutputPort())
    cleaned.PointMergingOff()
    cleaned.Update()
    write_geometry(cleaned.GetOutput(), path)


def write_geometry(data, path):
    writer = vtk.vtkPLYWriter()
    writer.SetInputData(data)
    writer.SetFileName(str(path))
    if not writer.Write():
        raise OSError(f"cannot write {path}")


def text_strip(lines, size):
    """Words in colours, one under the other."""
    step = FONT * PANEL[1] * 1.7 / size[1]
    actors = [pic.caption(words, (0.04, 0.62 - step * i if len(lines) > 1 else 0.25), (size[0], PANEL[1]), FONT, colour)
              for i, (words, colour) in enumerate(lines)]
    if len(lines) == 1:
        actors[0].GetTextProperty().SetJustificationToCentered()
        actors[0].SetPosition(0.5, 0.25)
    return pic.pixels_of(pic.new_renderer(*actors), size)


def titled_panel(shape, actors, title="", **view):
    picture = pic.panel(shape, actors, PANEL, **view)
    return np.vstack([picture, text_strip([(title, pic.INK)], (PANEL[0], TITLE_HEIGHT))]) if title else picture


def key(first, second):
    return text_strip([("■ " + first, RIDGE), ("■ " + second, VALLEY)], (LEGEND_WIDTH, PANEL[1]))


def lines_of(shape, path, width, colour=None):
    """The edges of a line file; without a colour, by their kind."""
    elements = tables(path)
    vertices = elements["vertex"]
    edges = elements.get("edge", np.zeros(0, dtype=[("vertex1", "i4"), ("vertex2", "i4")]))
    kinds = np.where(vertices["ii_kind"][:, None] > 0, RIDGE, VALLEY) if colour is None else np.tile(colour, (len(vertices), 1))
    return pic.lines_actor(shape.place(pic.positions(vertices)), np.column_stack([edges["vertex1"], edges["vertex2"]]), kinds, width)


def plain(shape):
    return pic.surface_actor(shape, np.tile(NEUTRAL, (len(shape.points), 1)))


def table_for(path, quantity, percentile):
    shape, signed = pic.Shape(path), quantity != "ii_radius"
    return pic.colour_table(signed, *pic.colour_range(shape.values(quantity)[shape.used], percentile, signed))


def curvature_row(data, names, titles, quantity, table, text, **view):
    """A panel a run, and the legend."""
    panels = []
    for name, title in zip(names, titles):
        shape = pic.Shape(data / f"{name}.ply")
        panels.append(titled_panel(shape, [pic.surface_actor(shape, shape.values(quantity), table)], title, **view))
    return panels + [pic.legend(table, text, (LEGEND_WIDTH, PANEL[1]), font=FONT)]


MEAN, RADIUS = "mean curvature\n1 / length", "radius\nlength"


def figure_2(data):
    """Directions of maximal curvature at a small, a large and the adapted radius, and by default."""
    row = []
    for radius, title in zip(RADII, TITLES):
        shape = pic.Shape(data / f"armadillo_{radius}.ply")
        lines = lines_of(shape, data / f"armadillo_directions_{radius}.ply", 1.3, (0.1, 0.1, 0.12))
        row.append(titled_panel(shape, [plain(shape), lines], title, **FACE))
    return [row]


def figure_3(data):
    """Radius and mean curvature before and after smoothing of the radius, on the noisy Buddha, where it matters."""
    names, titles = ("buddha_noisy_unsmoothed", "buddha_noisy_smoothed"), ("before smoothing", "after ten passes")
    smoothed = data / f"{names[1]}.ply"
    return [curvature_row(data, names, titles, "ii_radius", table_for(smoothed, "ii_radius", 100), RADIUS, **BUDDHA_FACE),
            curvature_row(data, names, titles, "mean", table_for(smoothed, "mean", 95), MEAN, **BUDDHA_FACE)]


def figure_4(data):
    """Mean curvature at a small, a large and the adapted radius, and by default, with close-ups."""
    names, table = [f"lucy_{radius}" for radius in RADII], table_for(data / "lucy_adapted.ply", "mean", 95)
    return [curvature_row(data, names, TITLES, "mean", table, MEAN, **LUCY),
            curvature_row(data, names, [""] * 4, "mean", table, MEAN, **LUCY, focus=(0.45, 0.72, 0.26))]


def figure_5(data):
    """The noisy Buddha."""
    names = ["buddha_clean_curvature"] + [f"buddha_noisy_curvature_{radius}" for radius in RADII]
    titles = ("no noise, adapted", "noise, fixed, 3 edges", "noise, fixed, 10 edges", "noise, adapted", "noise, default")
    table = table_for(data / f"{names[0]}.ply", "mean", 95)
    return [curvature_row(data, names, titles, "mean", table, MEAN, **BUDDHA),
            curvature_row(data, names, [""] * 5, "mean", table, MEAN, **BUDDHA_FACE)]


def figure_6(data):
    """Ridges and valleys at one scale against adapted ones and those of the default."""
    row = []
    for radius, title in zip(RADII, TITLES):
        shape = pic.Shape(data / f"armadillo_features_{radius}.ply")
        kind = shape.values("ii_feature")[:, None]
        colours = np.where(kind > 0, RIDGE, np.where(kind < 0, VALLEY, NEUTRAL))
        row.append(titled_panel(shape, [pic.surface_actor(shape, colours)], title, **ARMADILLO))
    return [row + [key("ridges", "valleys")]]


def figure_lines(data):
    """Crest lines, and lines of curvature: what the plugin adds to the paper."""
    shape = pic.Shape(data / "armadillo_statistical.ply")
    crest = titled_panel(shape, [plain(shape), lines_of(shape, data / "armadillo_crest.ply", 1.8)], "crest lines", **ARMADILLO)
    traced = titled_panel(shape, [plain(shape), lines_of(shape, data / "armadillo_lines.ply", 1.0)], "lines of curvature", **FACE)
    return [[crest, key("ridges", "valleys"), traced, key("maximal", "minimal")]]


FIGURES = {"fig2_directions": figure_2, "fig3_radius_smoothing": figure_3, "fig4_lucy": figure_4, "fig5_noisy_buddha": figure_5,
           "fig6_features": figure_6, "lines": figure_lines}


def filled(picture, height):
    """The picture with white below it, up to the height."""
    return np.vstack([picture, np.full((height - picture.shape[0], *picture.shape[1:]), 255, dtype=np.uint8)])


def draw(data, folder, names):
    for name in names or FIGURES:
        rows = FIGURES[name](data)
        pic.write_picture(folder / f"{name}.jpg", np.vstack(
            [np.hstack([filled(picture, max(p.shape[0] for p in row)) for picture in row]) for row in rows]))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("job", choices=["edge", "noise", "simplify", "draw"])
    parser.add_argument("words", nargs="+", help="edge MESH FACTOR, noise MESH SIGMA OUT, simplify MESH COUNT OUT, draw DATA FOLDER [FIGURE ...]")
    options = parser.parse_args()
    words = options.words
    if options.job == "draw":
        draw(pathlib.Path(words[0]), pathlib.Path(words[1]), words[2:])
    elif options.job == "edge":
        print(f"{float(words[1]) * average_edge(read_geometry(words[0])):.6g}")
    else:
        {"noise": write_noisy, "simplify": write_simplified}[options.job](read_geometry(words[0]), float(words[1]), words[2])
