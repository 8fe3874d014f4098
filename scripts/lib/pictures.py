#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a picture of a mesh that the filter exported: one quantity as colour, with a legend."""

import argparse
import pathlib
import sys
import textwrap

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

from exported import tables

BACKGROUND, INK = (1.0, 1.0, 1.0), (0.13, 0.14, 0.17)
SUPERSAMPLING = 2
LEGEND_PART = 0.16  # of a picture's width
FILLED = 0.92       # of a view, by the mesh

# Quantities by their names in the filter's dialog: unit, and whether they have a sign.
QUANTITIES = {
    "Mean curvature": ("1 / length", True), "Gaussian curvature": ("1 / length²", True),
    "Maximal curvature": ("1 / length", True), "Minimal curvature": ("1 / length", True), "Shape index": ("", True),
    "Curvedness": ("1 / length", False), "Radius": ("length", False), "Largest absolute curvature": ("1 / length", False),
}
PROPERTIES = {"ii_kmax": "Maximal curvature", "ii_kmin": "Minimal curvature", "ii_radius": "Radius", "mean": "Mean curvature",
              "gaussian": "Gaussian curvature"}
VIEWS = {"auto": ["25,15"], "front": ["0,5"], "back": ["180,5"], "three": ["0,5", "120,5", "240,5"]}

# Colour maps as anchors (r, g, b), evenly spaced, blended in CIELAB. Signed quantities: blue is concave, red convex, and
# zero a light grey that the lights can shade. Others: from dark violet to light yellow, brightness growing evenly.
DIVERGING = [(0.09, 0.21, 0.53), (0.23, 0.49, 0.77), (0.60, 0.78, 0.90), (0.93, 0.93, 0.92), (0.97, 0.72, 0.58),
             (0.84, 0.35, 0.30), (0.52, 0.04, 0.15)]
SEQUENTIAL = [(0.24, 0.15, 0.42), (0.20, 0.34, 0.56), (0.12, 0.54, 0.56), (0.30, 0.72, 0.45), (0.74, 0.83, 0.25),
              (0.99, 0.91, 0.45)]


class Shape:
    """A mesh with its values, brought to the origin and to size 1: graphics work in single precision, in which a mesh far
    from the origin or of extreme size would lose its shape."""

    def __init__(self, path):
        self.table = tables(path)["vertex"]
        reader = vtk.vtkPLYReader()
        reader.SetFileName(str(path))
        reader.Update()
        self.cells = reader.GetOutput().GetPolys()
        corners = vtk_to_numpy(self.cells.GetConnectivityArray())
        self.used = np.unique(corners) if len(corners) else np.arange(len(self.table))
        points = positions(self.table)
        self.centre = points[self.used].mean(axis=0)
        self.size = np.linalg.norm(np.ptp(points[self.used], axis=0)) or 1
        self.points = self.place(points)

    def place(self, points):
        return (points - self.centre) / self.size

    def values(self, name):
        if name in ("mean", "gaussian"):
            kmax, kmin = self.values("ii_kmax"), self.values("ii_kmin")
            return (kmax + kmin) / 2 if name == "mean" else kmax * kmin
        if name not in self.table.dtype.names:
            raise ValueError(f"the mesh has no vertex property '{name}'; it has: {', '.join(self.table.dtype.names)}")
        return self.table[name].astype(float)


def positions(table):
    return np.column_stack([table[axis] for axis in "xyz"]).astype(float)


def colour_range(values, percentile, signed):
    """Outliers would leave the rest in one colour, so the range is that of most values; symmetric when there is a sign."""
    if signed:
        bound = np.percentile(np.abs(values), percentile)
        return (-bound, bound) if bound > 0 else (-1, 1)
    tail = (100 - percentile) / 2
    low, high = np.percentile(values, [tail, 100 - tail])
    return (low, high) if high > low else (low - abs(low) / 2, high + abs(high) / 2 or 1)


def colour_table(signed, low, high):
    anchors = DIVERGING if signed else SEQUENTIAL
    blend, table = vtk.vtkColorTransferFunction(), vtk.vtkLookupTable()
    blend.SetColorSpaceToLab()
    for i, colour in enumerate(anchors):
        blend.AddRGBPoint(i / (len(anchors) - 1), *colour)
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *blend.GetColor(i / 255), 1)
    table.SetTableRange(low, high)
    return table


def poly_data(points, scalars):
    data, vtk_points = vtk.vtkPolyData(), vtk.vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(vtk_points)
    data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(scalars), deep=True))
    return data


def surface_actor(shape, values, table=None):
    """`values`: a number a vertex, coloured by the table; without one, a colour (r, g, b from 0 to 1) a vertex."""
    data = poly_data(shape.points, values if table else (255 * values).astype(np.uint8))
    data.SetPolys(shape.cells)
    normals, mapper, actor = vtk.vtkPolyDataNormals(), vtk.vtkPolyDataMapper(), vtk.vtkActor()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.ConsistencyOff()
    mapper.SetInputConnection(normals.GetOutputPort())
    if table:
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
        mapper.InterpolateScalarsBeforeMappingOn()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetInterpolationToPhong()
    look.SetAmbient(0.16)
    look.SetDiffuse(0.88)
    look.SetSpecular(0.10)
    look.SetSpecularPower(25)
    return actor


def lines_actor(points, edges, colours, width):
    """Edges (pairs of indices), lifted off the surface by the depth offset of the mapper rather than by moving them."""
    data, lines = poly_data(points, (255 * colours).astype(np.uint8)), vtk.vtkCellArray()
    cells = np.column_stack([np.full(len(edges), 2), edges]).astype(np.int64)
    lines.SetCells(len(edges), numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells.ravel()), deep=True))
    data.SetLines(lines)
    mapper, actor = vtk.vtkPolyDataMapper(), vtk.vtkActor()
    mapper.SetInputData(data)
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -10)
    actor.SetMapper(mapper)
    actor.GetProperty().SetLineWidth(width * SUPERSAMPLING)
    actor.GetProperty().LightingOff()
    return actor


def add_lights(renderer):
    """A key light over the left shoulder, a weaker fill light, and one from behind that draws the outline; all move with
    the camera."""
    renderer.AutomaticLightCreationOff()
    for position, strength, colour in (((-0.7, 0.9, 1.0), 0.75, (1.0, 0.98, 0.95)), ((1.2, 0.1, 0.9), 0.38, (0.93, 0.96, 1.0)),
                                       ((0.1, -0.9, 0.6), 0.30, (1.0, 1.0, 1.0)), ((0.5, 1.2, -1.0), 0.35, (1.0, 1.0, 1.0))):
        light = vtk.vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(*position)
        light.SetFocalPoint(0, 0, 0)
        light.SetIntensity(strength)
        light.SetColor(*colour)
        renderer.AddLight(light)


def add_ambient_occlusion(renderer):
    """The bias is what a surface seen from the side needs to show no stripes."""
    occlusion = vtk.vtkSSAOPass()
    occlusion.SetRadius(0.05)
    occlusion.SetBias(0.006)
    occlusion.SetKernelSize(128)
    occlusion.BlurOn()
    occlusion.SetDelegatePass(vtk.vtkRenderStepsPass())
    renderer.SetPass(occlusion)


def view_directions(view, up_axis, points):
    """Unit vectors from the mesh to the camera, to the right and upward. Most meshes of figures stand along y and face +z; a
    scene whose z is its shortest side lies on the ground and is looked at from above."""
    extent = np.ptp(points, axis=0)
    lies = up_axis == "auto" and extent[2] < 0.35 * min(extent[0], extent[1])
    up = np.eye(3)["xyz".index("z" if lies else "y" if up_axis == "auto" else up_axis)]
    front = np.array([0, -1.0, 0]) if up[2] else np.array([0, 0, 1.0])
    if view == VIEWS["auto"][0] and up[2]:
        view = "20,50"
    if "," in view:
        azimuth, elevation = (np.radians(float(angle)) for angle in view.split(","))
        level = np.cos(azimuth) * front + np.sin(azimuth) * np.cross(up, front)
        toward = np.cos(elevation) * level + np.sin(elevation) * up
    else:
        toward = sum({"+": 1, "-": -1}[sign] * np.eye(3)["xyz".index(axis)] for sign, axis in zip(view[0::2], view[1::2]))
        toward = toward / np.linalg.norm(toward)
    if abs(toward @ up) > 0.99:
        up = front
    right = np.cross(up, toward)
    right /= np.linalg.norm(right)
    return toward, right, np.cross(toward, right)


def place_camera(renderer, points, axes, focus, size):
    """Fits the mesh as seen into the view; `focus`, (right, up, height) in parts of its extent, shows that part alone."""
    toward, right, up = axes
    low = np.array([(points @ axis).min() for axis in (right, up)])
    extent = np.array([np.ptp(points @ axis) for axis in (right, up)])
    half = focus[2] * extent[1] / 2 if focus else max(extent[1], extent[0] * size[1] / size[0]) / 2 / FILLED
    u, v = low + np.array(focus[:2] if focus else (0.5, 0.5)) * extent
    target = u * right + v * up
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(half or 1)
    camera.SetFocalPoint(*target)
    camera.SetPosition(*(target + 5 * toward))
    camera.SetViewUp(*up)
    renderer.ResetCameraClippingRange()


def new_renderer(*things):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(*BACKGROUND)
    for thing in things:
        renderer.AddViewProp(thing)
    return renderer


def panel(shape, actors, size, view="25,15", up="auto", focus=None):
    """One view as an array of pixels."""
    renderer = new_renderer(*actors)
    add_lights(renderer)
    points = shape.points[shape.used]
    place_camera(renderer, points, view_directions(view, up, points), focus, size)
    if focus is None:  # from near, what occludes would be facets
        add_ambient_occlusion(renderer)
    return pixels_of(renderer, size)


def round_ticks(low, high):
    """Values at steps of 1, 2 or 5 times a power of ten within the range: four to nine of them."""
    rough = (high - low) / 8
    power = 10.0 ** np.floor(np.log10(rough))
    step = power * next(m for m in (1, 2, 5, 10) if m * power >= rough)
    return [k * step for k in range(int(np.ceil(low / step - 1e-9)), int(np.floor(high / step + 1e-9)) + 1)]


def legend(table, text, size, below="", font=0.0205):
    """The colours of a table, what they show above it, and a remark below."""
    bar, ticks = vtk.vtkScalarBarActor(), vtk.vtkDoubleArray()
    bar.SetLookupTable(table)
    bar.SetMaximumNumberOfColors(256)
    for value in round_ticks(*table.GetTableRange()):
        ticks.InsertNextValue(value)
    bar.SetUseCustomLabels(True)
    bar.SetCustomLabels(ticks)
    bar.SetNumberOfLabels(ticks.GetNumberOfValues())
    bar.SetLabelFormat("  %.4g")
    bar.UnconstrainedFontSizeOn()
    bar.SetBarRatio(0.23)
    bar.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    bar.GetPositionCoordinate().SetValue(0.12, 0.14)
    bar.SetWidth(0.8)
    bar.SetHeight(0.66)
    set_font(bar.GetLabelTextProperty(), font, size)
    return pixels_of(new_renderer(bar, caption(text, (0.12, 0.83), size, font), caption(below, (0.12, 0.05), size, 0.8 * font)), size)


def set_font(style, font, size, colour=INK):
    style.SetFontFamilyToArial()
    style.SetFontSize(int(font * SUPERSAMPLING * size[1]))
    style.SetColor(*colour)
    for off in (style.ItalicOff, style.BoldOff, style.ShadowOff):
        off()


def caption(text, position, size, font, colour=INK):
    actor = vtk.vtkTextActor()
    actor.SetInput(text)
    set_font(actor.GetTextProperty(), font, size, colour)
    actor.GetTextProperty().SetLineSpacing(1.3)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(*position)
    return actor


def pixels_of(renderer, size):
    window, grab, smaller = vtk.vtkRenderWindow(), vtk.vtkWindowToImageFilter(), vtk.vtkImageResize()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*(SUPERSAMPLING * s for s in size))
    window.AddRenderer(renderer)
    window.Render()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    smaller.SetInputConnection(grab.GetOutputPort())
    smaller.SetOutputDimensions(*size, 1)
    smaller.Update()
    scalars = smaller.GetOutput().GetPointData().GetScalars()
    pixels = vtk_to_numpy(scalars).reshape(size[1], size[0], -1)[::-1, :, :3].copy()
    window.Finalize()  # gives the connection to the X server back
    return pixels


def write_picture(path, pixels):
    image = vtk.vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(pixels[::-1].reshape(-1, 3)), deep=True))
    writer = vtk.vtkPNGWriter() if str(path).endswith(".png") else vtk.vtkJPEGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.Write()
    if writer.GetErrorCode() or not pathlib.Path(path).is_file():
        raise OSError(f"cannot write {path}")


def direction_lines(shape, name):
    """Both senses of a direction are the same, so each is a line through its vertex."""
    vectors = np.column_stack([shape.values(f"{name}_{axis}") for axis in "xyz"])[shape.used]
    half = 0.45 * vectors * np.sqrt(2 / len(shape.used))  # about the distance between vertices, of a shape of size 1
    points = np.vstack([shape.points[shape.used] - half, shape.points[shape.used] + half])
    edges = np.arange(len(points)).reshape(2, -1).T
    return lines_actor(points, edges, np.tile(INK, (len(points), 1)), 1.6)


def draw(options):
    shape = Shape(options.mesh)
    values = shape.values(options.quantity)
    name = PROPERTIES.get(options.quantity, options.quality_is if options.quantity == "quality" else options.quantity)
    used = values[shape.used]
    unit, signed = QUANTITIES.get(name, ("", bool(used.min() < 0)))
    low, high = options.range or colour_range(used, options.percentile, signed)
    table = colour_table(signed, low, high)
    actors = [surface_actor(shape, values, table)]
    if options.directions:
        actors.append(direction_lines(shape, options.directions))
    width, height = options.size
    beyond = f"beyond the ends:\n{100 * np.mean(used > high):.1f} % above,\n{100 * np.mean(used < low):.1f} % below"
    side = legend(table, f"{textwrap.fill(name, 18)}\n{unit}", (int(LEGEND_PART * width), height), beyond)
    views = VIEWS.get(options.view, [options.view])
    size = ((width - side.shape[1]) // len(views), height)
    write_picture(options.picture, np.hstack([panel(shape, actors, size, view, options.up) for view in views] + [side]))


def parse_arguments(argv):
    parser = argparse.ArgumentParser(prog="pictures.py", description=__doc__)
    parser.add_argument("mesh", help="PLY file with the values as vertex properties")
    parser.add_argument("picture", help="PNG or JPEG file to write")
    parser.add_argument("--quantity", default="quality",
                        help="vertex property to show, or 'mean' or 'gaussian', which come from ii_kmax and ii_kmin")
    parser.add_argument("--quality-is", metavar="NAME", default="", help="what 'quality' holds: one of " + ", ".join(QUANTITIES))
    parser.add_argument("--percentile", type=float, default=95,
                        help="the colours span this part of the values, of 100 (default %(default)s)")
    parser.add_argument("--range", type=float, nargs=2, metavar=("LOW", "HIGH"), help="values at the ends of the colours")
    parser.add_argument("--view", default="auto", help="where the camera stands: auto, front, back, three (views round the mesh), "
                        "+x, -x, +y, -y, +z, -z, two of them as +x+y, or 'AZIMUTH,ELEVATION' in degrees (default: %(default)s)")
    parser.add_argument("--up", default="auto", choices=["auto", "x", "y", "z"], help="axis that points up")
    parser.add_argument("--directions", choices=["ii_dirmax", "ii_dirmin"], help="draw these directions as short lines")
    parser.add_argument("--size", type=int, nargs=2, default=(1600, 1200), metavar=("WIDTH", "HEIGHT"))
    return parser.parse_args(argv)


if __name__ == "__main__":
    try:
        draw(parse_arguments(sys.argv[1:]))
    except (OSError, ValueError, KeyError) as problem:
        sys.exit(f"pictures.py: {problem}")
