#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the figures of [Lai09] from the runs that scripts/figures made: panels side by side, one legend a figure."""

import pathlib
import sys

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

import render_curvature as rc
from ply import read_edges, read_ply

PANEL = (440, 540)
TITLE_HEIGHT = 34
LEGEND_WIDTH = 150
RIDGE, VALLEY, NEUTRAL = (0.77, 0.13, 0.17), (0.13, 0.33, 0.75), (0.82, 0.82, 0.81)


class Shape:
    """A mesh with its values, its size brought to 1 around the origin."""

    def __init__(self, path):
        self.vertices, self.triangles = read_ply(path)
        points = np.column_stack([self.vertices[axis] for axis in "xyz"]).astype(float)
        self.used = np.unique(self.triangles)
        self.centre = points[self.used].mean(axis=0)
        self.size = np.linalg.norm(np.ptp(points[self.used], axis=0))
        self.points = self.place(points)

    def place(self, points):
        return (points - self.centre) / self.size

    def values(self, quantity):
        return rc.quantity_of(self.vertices, quantity)


def lines_actor(shape, path, width=1.5, colour=None):
    """The edges of a line file, lifted a little by the depth offset of the mapper."""
    vertices, _ = read_ply(path)
    points = shape.place(np.column_stack([vertices[axis] for axis in "xyz"]).astype(float))
    edges = read_edges(path)
    data = vtk.vtkPolyData()
    vtk_points = vtk.vtkPoints()
    vtk_points.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(vtk_points)
    cells = np.column_stack([np.full(len(edges), 2), edges]).astype(np.int64)
    lines = vtk.vtkCellArray()
    lines.SetCells(len(edges), numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells.ravel()), deep=True))
    data.SetLines(lines)
    colours = np.where(vertices["ii_kind"][:, None] > 0, RIDGE, VALLEY) if colour is None else np.tile(colour, (len(points), 1))
    data.GetPointData().SetScalars(numpy_to_vtk((255 * colours).astype(np.uint8), deep=True))
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -12)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetLineWidth(width * rc.SUPERSAMPLING)
    actor.GetProperty().LightingOff()
    return actor


def coloured_actor(shape, colours):
    data = rc.poly_data(shape.points, shape.triangles, (255 * colours).astype(np.uint8))
    actor = rc.surface_actor(data, rc.colour_table(False, 0, 1))
    actor.GetMapper().InterpolateScalarsBeforeMappingOff()
    actor.GetMapper().SetColorModeToDirectScalars()
    return actor


def plain_actor(shape):
    return coloured_actor(shape, np.tile(NEUTRAL, (len(shape.points), 1)))


def feature_actor(shape):
    kind = shape.values("ii_feature")
    colours = np.where(kind[:, None] > 0, RIDGE, np.where(kind[:, None] < 0, VALLEY, NEUTRAL))
    return coloured_actor(shape, colours)


def place_camera(renderer, shape, view, up_axis, focus, size):
    """`focus`: (right, up, height) in parts of the shape's extent as seen; None: all of it."""
    toward, up = rc.view_directions(view, up_axis, shape.points[shape.used])
    right = np.cross(up, toward)
    right /= np.linalg.norm(right)
    up = np.cross(toward, right)
    points = shape.points[shape.used]
    low = np.array([(points @ a).min() for a in (right, up)])
    extent = np.array([np.ptp(points @ a) for a in (right, up)])
    if focus is None:
        part, half = (0.5, 0.5), max(extent[1], extent[0] * size[1] / size[0]) / 2 * 1.06
    else:
        part, half = focus[:2], focus[2] * extent[1] / 2
    u, v = low + np.array(part) * extent
    target = u * right + v * up
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(half)
    camera.SetFocalPoint(*target)
    camera.SetPosition(*(target + 5 * toward))
    camera.SetViewUp(*up)
    renderer.ResetCameraClippingRange()


def panel(shape, actors, view="auto", up="y", focus=None, title="", size=PANEL):
    """One view as an array of pixels, with its title below it, if any."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(*rc.BACKGROUND)
    for actor in actors:
        renderer.AddActor(actor)
    renderer.AutomaticLightCreationOff()
    rc.add_lights(renderer)
    place_camera(renderer, shape, view, up, focus, size)
    if focus is None:  # from near, what occludes would be facets
        rc.add_ambient_occlusion(renderer, 1.0)
    picture = pixels_of([renderer], size)
    return np.vstack([picture, title_strip(title, size[0])]) if title else picture


def title_strip(title, width):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(*rc.BACKGROUND)
    text = rc.caption(title, (0.5, 0.9), (width, TITLE_HEIGHT), 0)
    text.GetTextProperty().SetFontSize(int(rc.SUPERSAMPLING * 15))
    text.GetTextProperty().SetJustificationToCentered()
    text.GetTextProperty().SetVerticalJustificationToTop()
    renderer.AddActor2D(text)
    return pixels_of([renderer], (width, TITLE_HEIGHT))


def legend(table, name, unit, height):
    size = (LEGEND_WIDTH, height)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(*rc.BACKGROUND)
    pixels = [rc.SUPERSAMPLING * s for s in size]
    bar = rc.legend(table, pixels)
    bar.GetPositionCoordinate().SetValue(0.05, 0.16)
    bar.SetWidth(0.85)
    bar.SetHeight(0.6)
    bar.GetLabelTextProperty().SetFontSize(int(rc.SUPERSAMPLING * 14))
    renderer.AddActor2D(bar)
    text = rc.caption(f"{name}\n{unit}", (0.97, 0.92), pixels, 0)
    text.GetTextProperty().SetFontSize(int(rc.SUPERSAMPLING * 15))
    text.GetTextProperty().SetJustificationToRight()
    text.GetTextProperty().SetVerticalJustificationToTop()
    renderer.AddActor2D(text)
    return pixels_of([renderer], size)


def key(entries, height):
    """A legend of colours with words."""
    size = (LEGEND_WIDTH, height)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(*rc.BACKGROUND)
    for i, (colour, words) in enumerate(entries):
        text = rc.caption("■ " + words, (0.04, 0.62 - 0.07 * i), size, 0)
        text.GetTextProperty().SetFontSize(int(rc.SUPERSAMPLING * 15))
        text.GetTextProperty().SetJustificationToLeft()
        text.GetTextProperty().SetColor(*colour)
        renderer.AddActor2D(text)
    return pixels_of([renderer], size)


def pixels_of(renderers, size):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*(rc.SUPERSAMPLING * s for s in size))
    window.SetNumberOfLayers(len(renderers))
    for renderer in renderers:
        window.AddRenderer(renderer)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    smaller = vtk.vtkImageResize()
    smaller.SetInputConnection(grab.GetOutputPort())
    smaller.SetOutputDimensions(*size, 1)
    smaller.Update()
    image = smaller.GetOutput()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(size[1], size[0], -1)[::-1, :, :3].copy()
    window.Finalize()  # gives the connection to the X server back
    return pixels


def save(path, rows):
    """Rows of panels, from the top, as a JPEG."""
    rows = [np.hstack([filled(picture, max(p.shape[0] for p in row)) for picture in row]) for row in rows]
    pixels = np.vstack(rows)[::-1]
    image = vtk.vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(pixels.reshape(-1, 3)), deep=True))
    writer = vtk.vtkJPEGWriter()
    writer.SetInputData(image)
    writer.SetQuality(85)
    writer.SetFileName(str(path))
    writer.Write()
    if writer.GetErrorCode():
        raise OSError(f"cannot write {path}")


def filled(picture, height):
    """The picture with white below it, up to the height."""
    below = np.full((height - picture.shape[0], *picture.shape[1:]), 255, dtype=np.uint8)
    return np.vstack([picture, below])


def curvature_panels(data, names, titles, quantity, table, **view):
    panels = []
    for name, title in zip(names, titles):
        shape = Shape(data / f"{name}.ply")
        surface = rc.surface_actor(rc.poly_data(shape.points, shape.triangles, shape.values(quantity)), table)
        panels.append(panel(shape, [surface], title=title, **view))
    return panels


def table_for(data, name, quantity, percentile=96):
    shape = Shape(data / f"{name}.ply")
    signed = quantity != "ii_radius"
    return rc.colour_table(signed, *rc.colour_range(shape.values(quantity)[shape.used], percentile, signed))


THREE = ("small", "large", "adapted")
ALL = THREE + ("statistical",)
TITLES = ("fixed, 2 edges", "fixed, 8 edges", "adapted, 2 to 8 edges", "default of this plugin")
ARMADILLO = {"view": "180,5"}
LUCY = {"view": "180,5", "up": "z"}
FACE = {"view": "180,5", "focus": (0.5, 0.84, 0.30)}
BUDDHA_FACE = {"view": "0,5", "focus": (0.5, 0.84, 0.28)}


def figure_2(data):
    """Directions of maximal curvature at a small, a large and the adapted radius, and by default."""
    panels = []
    for radius, title in zip(ALL, TITLES):
        shape = Shape(data / f"armadillo_{radius}.ply")
        lines = lines_actor(shape, data / f"armadillo_directions_{radius}.ply", 1.3, (0.1, 0.1, 0.12))
        panels.append(panel(shape, [plain_actor(shape), lines], title=title, **FACE))
    return [panels]


def figure_3(data):
    """Radius and mean curvature before and after smoothing of the radius, on the noisy Buddha, where it matters."""
    names, titles = ("buddha_noisy_unsmoothed", "buddha_noisy_smoothed"), ("before smoothing", "after ten passes")
    radius, mean = table_for(data, names[1], "ii_radius", 100), table_for(data, names[1], "mean", 95)
    return [curvature_panels(data, names, titles, "ii_radius", radius, **BUDDHA_FACE) +
            [legend(radius, "radius", "length", PANEL[1])],
            curvature_panels(data, names, titles, "mean", mean, **BUDDHA_FACE) +
            [legend(mean, "mean curvature", "1 / length", PANEL[1])]]


def figure_4(data):
    """Mean curvature at a small, a large and the adapted radius, and by default, with close-ups."""
    names = [f"lucy_{radius}" for radius in ALL]
    table = table_for(data, names[2], "mean", 95)
    close = {**LUCY, "focus": (0.45, 0.72, 0.26)}
    return [curvature_panels(data, names, TITLES, "mean", table, **LUCY) +
            [legend(table, "mean curvature", "1 / length", PANEL[1])],
            curvature_panels(data, names, [""] * 4, "mean", table, **close) + [blank(PANEL[1])]]


def figure_5(data):
    """The noisy Buddha."""
    names = ["buddha_clean_curvature"] + [f"buddha_noisy_curvature_{radius}" for radius in ALL]
    titles = ("no noise, adapted", "noise, fixed, 3 edges", "noise, fixed, 10 edges", "noise, adapted", "noise, default")
    table = table_for(data, names[0], "mean", 95)
    return [curvature_panels(data, names, titles, "mean", table, view="0,5") +
            [legend(table, "mean curvature", "1 / length", PANEL[1])],
            curvature_panels(data, names, [""] * 5, "mean", table, **BUDDHA_FACE) + [blank(PANEL[1])]]


def figure_6(data):
    """Ridges and valleys at one scale against adapted ones and those of the default."""
    panels = []
    for radius, title in zip(ALL, TITLES):
        shape = Shape(data / f"armadillo_features_{radius}.ply")
        panels.append(panel(shape, [feature_actor(shape)], title=title, **ARMADILLO))
    return [panels + [key([(RIDGE, "ridges"), (VALLEY, "valleys")], PANEL[1])]]


def figure_lines(data):
    """Crest lines, and lines of curvature: what the plugin adds to the paper."""
    shape = Shape(data / "armadillo_statistical.ply")
    crest = panel(shape, [plain_actor(shape), lines_actor(shape, data / "armadillo_crest.ply", 1.8)],
                  title="crest lines", **ARMADILLO)
    traced = panel(shape, [plain_actor(shape), lines_actor(shape, data / "armadillo_lines.ply", 1.0)],
                   title="lines of curvature", **FACE)
    return [[crest, key([(RIDGE, "ridges"), (VALLEY, "valleys")], PANEL[1]), traced,
             key([(RIDGE, "maximal"), (VALLEY, "minimal")], PANEL[1])]]


def blank(height):
    return np.full((height, LEGEND_WIDTH, 3), 255, dtype=np.uint8)


FIGURES = {"fig2_directions": figure_2, "fig3_radius_smoothing": figure_3, "fig4_lucy": figure_4, "fig5_noisy_buddha": figure_5,
           "fig6_features": figure_6, "lines": figure_lines}


def main(argv):
    if len(argv) < 2:
        print("Usage: draw_figures.py DATA_FOLDER PICTURE_FOLDER [FIGURE ...]", file=sys.stderr)
        return 2
    data, pictures = pathlib.Path(argv[0]), pathlib.Path(argv[1])
    # Xvfb begins anew when its last window closes, and refuses new ones meanwhile: one stays open.
    anchor = vtk.vtkRenderWindow()
    anchor.SetOffScreenRendering(1)
    anchor.SetSize(8, 8)
    anchor.Render()
    for name in argv[2:] or FIGURES:
        save(pictures / f"{name}.jpg", FIGURES[name](data))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
