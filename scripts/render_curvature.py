#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a picture of a mesh that the filter exported: one quantity as colour, with a legend."""

import argparse
import pathlib
import sys
import textwrap

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

from ply import read_ply

BACKGROUND = (1.0, 1.0, 1.0)
INK = (0.13, 0.14, 0.17)
SUPERSAMPLING = 2
MESH_PART = 0.84  # of the picture's width; the legend has the rest
FILLED = 0.92     # of the mesh's part

# Quantities by their names in the filter's dialog: unit, and whether they have a sign.
QUANTITIES = {
    "Mean curvature": ("1 / length", True),
    "Gaussian curvature": ("1 / length²", True),
    "Maximal curvature": ("1 / length", True),
    "Minimal curvature": ("1 / length", True),
    "Shape index": ("", True),
    "Curvedness": ("1 / length", False),
    "Radius": ("length", False),
    "Largest absolute curvature": ("1 / length", False),
}
NAMES = {"ii_kmax": "Maximal curvature", "ii_kmin": "Minimal curvature", "ii_radius": "Radius", "mean": "Mean curvature",
         "gaussian": "Gaussian curvature"}

# Colour maps as anchors (r, g, b), evenly spaced, blended in CIELAB. Signed quantities: blue is concave, red convex, and
# zero a light grey that the lights can shade. Others: from dark violet to light yellow, brightness growing evenly.
DIVERGING = [(0.09, 0.21, 0.53), (0.23, 0.49, 0.77), (0.60, 0.78, 0.90), (0.93, 0.93, 0.92), (0.97, 0.72, 0.58),
             (0.84, 0.35, 0.30), (0.52, 0.04, 0.15)]
SEQUENTIAL = [(0.24, 0.15, 0.42), (0.20, 0.34, 0.56), (0.12, 0.54, 0.56), (0.30, 0.72, 0.45), (0.74, 0.83, 0.25),
              (0.99, 0.91, 0.45)]


def parse_arguments(argv):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mesh", help="PLY file with the values as vertex properties")
    parser.add_argument("picture", help="PNG file to write")
    parser.add_argument("--quantity", default="quality",
                        help="vertex property to show, or 'mean' or 'gaussian', which come from ii_kmax and ii_kmin")
    parser.add_argument("--quality-is", metavar="NAME", default="", help="what the property 'quality' holds: one of "
                        + ", ".join(QUANTITIES))
    parser.add_argument("--percentile", type=float, default=95,
                        help="the colours span this part of the values, of 100 (default %(default)s)")
    parser.add_argument("--range", type=float, nargs=2, metavar=("LOW", "HIGH"), help="values at the ends of the colours")
    parser.add_argument("--view", default="auto",
                        help="where the camera stands: +x, -x, +y, -y, +z, -z, two of them as +x+y, or three angles free: "
                             "'AZIMUTH,ELEVATION' in degrees (default: %(default)s)")
    parser.add_argument("--up", default="auto", choices=["auto", "x", "y", "z"], help="axis that points up")
    parser.add_argument("--zoom", type=float, default=1, help="size of the mesh in the picture (default %(default)s)")
    parser.add_argument("--directions", choices=["ii_dirmax", "ii_dirmin"], help="draw these directions as short lines")
    parser.add_argument("--size", type=int, nargs=2, default=(1600, 1200), metavar=("WIDTH", "HEIGHT"))
    return parser.parse_args(argv)


def quantity_of(vertices, name):
    if name in ("mean", "gaussian"):
        kmax, kmin = vertices["ii_kmax"].astype(float), vertices["ii_kmin"].astype(float)
        return (kmax + kmin) / 2 if name == "mean" else kmax * kmin
    if name not in vertices:
        raise ValueError(f"the mesh has no vertex property '{name}'; it has: {', '.join(vertices)}")
    return vertices[name].astype(float)


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
    blend = vtk.vtkColorTransferFunction()
    blend.SetColorSpaceToLab()
    for i, colour in enumerate(anchors):
        blend.AddRGBPoint(i / (len(anchors) - 1), *colour)
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *blend.GetColor(i / 255), 1)
    table.SetTableRange(low, high)
    return table


def poly_data(points, triangles, values):
    data = vtk.vtkPolyData()
    vtk_points = vtk.vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(vtk_points)
    cells = np.hstack([np.full((len(triangles), 1), 3), triangles]).astype(np.int64)
    polys = vtk.vtkCellArray()
    polys.SetCells(len(triangles), numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells.ravel()), deep=True))
    data.SetPolys(polys)
    data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(values), deep=True))
    return data


def surface_actor(data, table):
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.ConsistencyOff()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetInterpolationToPhong()
    look.SetAmbient(0.16)
    look.SetDiffuse(0.88)
    look.SetSpecular(0.10)
    look.SetSpecularPower(25)
    return actor


def direction_lines(points, directions, length):
    """Both senses of a direction are the same, so each is a line through its vertex; lifted off the surface by the depth
    offset of the mapper rather than by moving it."""
    count = len(points)
    ends = np.empty((2 * count, 3))
    ends[0::2] = points - 0.5 * length * directions
    ends[1::2] = points + 0.5 * length * directions
    data = vtk.vtkPolyData()
    vtk_points = vtk.vtkPoints()
    vtk_points.SetData(numpy_to_vtk(ends, deep=True))
    data.SetPoints(vtk_points)
    cells = np.column_stack([np.full(count, 2), np.arange(0, 2 * count, 2), np.arange(1, 2 * count, 2)]).astype(np.int64)
    lines = vtk.vtkCellArray()
    lines.SetCells(count, numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells.ravel()), deep=True))
    data.SetLines(lines)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -8)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*INK)
    actor.GetProperty().SetLineWidth(1.6 * SUPERSAMPLING)
    actor.GetProperty().LightingOff()
    return actor


def add_lights(renderer):
    """A key light over the left shoulder, a weaker fill light, and one from behind that draws the outline; all move with
    the camera."""
    for position, strength, colour in (((-0.7, 0.9, 1.0), 0.75, (1.0, 0.98, 0.95)),
                                       ((1.2, 0.1, 0.9), 0.38, (0.93, 0.96, 1.0)),
                                       ((0.1, -0.9, 0.6), 0.30, (1.0, 1.0, 1.0)),
                                       ((0.5, 1.2, -1.0), 0.35, (1.0, 1.0, 1.0))):
        light = vtk.vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(*position)
        light.SetFocalPoint(0, 0, 0)
        light.SetIntensity(strength)
        light.SetColor(*colour)
        renderer.AddLight(light)


def add_ambient_occlusion(renderer, diagonal):
    basic = vtk.vtkRenderStepsPass()
    occlusion = vtk.vtkSSAOPass()
    occlusion.SetRadius(0.05 * diagonal)
    occlusion.SetBias(0.002 * diagonal)
    occlusion.SetKernelSize(64)
    occlusion.BlurOn()
    occlusion.SetDelegatePass(basic)
    renderer.SetPass(occlusion)


def view_directions(view, up_axis, points):
    """Unit vectors from the mesh to the camera, and upward. Most meshes of figures stand along y and face +z; a scene whose
    z is its shortest side lies on the ground and is looked at from above."""
    extent = points.max(axis=0) - points.min(axis=0)
    if up_axis == "auto":
        up_axis = "z" if extent[2] < 0.35 * min(extent[0], extent[1]) else "y"
    up = np.eye(3)["xyz".index(up_axis)]
    front = np.array([0, 0, 1.0]) if up_axis != "z" else np.array([0, -1.0, 0])
    side = np.cross(up, front)
    if view == "auto":
        view = "25,15" if up_axis != "z" else "20,50"
    if "," in view:
        azimuth, elevation = (np.radians(float(v)) for v in view.split(","))
        toward = (np.cos(elevation) * (np.cos(azimuth) * front + np.sin(azimuth) * side) + np.sin(elevation) * up)
    else:
        toward = np.zeros(3)
        for sign, axis in zip(view[0::2], view[1::2]):
            toward["xyz".index(axis)] += {"+": 1, "-": -1}[sign]
    toward /= np.linalg.norm(toward)
    if abs(toward @ up) > 0.99:
        up = front
    return toward, up


def place_camera(renderer, points, options):
    """Fits the mesh as seen, not its bounding sphere, into the part of the picture beside the legend."""
    toward, up = view_directions(options.view, options.up, points)
    right = np.cross(up, toward)
    right /= np.linalg.norm(right)
    up = np.cross(toward, right)
    u, v, depth = points @ right, points @ up, points @ toward
    centre = ((u.max() + u.min()) * right + (v.max() + v.min()) * up + (depth.max() + depth.min()) * toward) / 2
    aspect = MESH_PART * options.size[0] / options.size[1]
    half = max(np.ptp(v), np.ptp(u) / aspect) / 2 / FILLED / options.zoom
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(half)
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(centre + (4 * half + 2 * np.ptp(depth)) * toward))
    camera.SetViewUp(*up)
    renderer.ResetCameraClippingRange()


def round_ticks(low, high):
    """Values at steps of 1, 2 or 5 times a power of ten within the range: four to nine of them."""
    rough = (high - low) / 8
    power = 10.0 ** np.floor(np.log10(rough))
    step = power * next(m for m in (1, 2, 5, 10) if m * power >= rough)
    return [k * step for k in range(int(np.ceil(low / step - 1e-9)), int(np.floor(high / step + 1e-9)) + 1)]


def legend(table, size):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetMaximumNumberOfColors(256)
    ticks = vtk.vtkDoubleArray()
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
    style = bar.GetLabelTextProperty()
    style.SetFontFamilyToArial()
    style.SetFontSize(int(0.021 * size[1]))
    style.SetColor(*INK)
    style.ItalicOff()
    style.BoldOff()
    style.ShadowOff()
    return bar


def caption(text, position, size, scale):
    actor = vtk.vtkTextActor()
    actor.SetInput(text)
    style = actor.GetTextProperty()
    style.SetFontFamilyToArial()
    style.SetFontSize(int(scale * size[1]))
    style.SetColor(*INK)
    style.SetJustificationToLeft()
    style.SetVerticalJustificationToBottom()
    style.SetLineSpacing(1.3)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(*position)
    return actor


def average_edge(points, triangles):
    return np.mean([np.linalg.norm(points[triangles[:, i]] - points[triangles[:, i - 1]], axis=1).mean() for i in range(3)])


def draw(options):
    vertices, triangles = read_ply(options.mesh)
    points = np.column_stack([vertices[axis] for axis in "xyz"]).astype(float)
    values = quantity_of(vertices, options.quantity)
    name = NAMES.get(options.quantity, options.quality_is if options.quantity == "quality" else options.quantity)
    unit, signed = QUANTITIES.get(name, ("", bool(values.min() < 0)))
    used = np.unique(triangles)
    low, high = options.range or colour_range(values[used], options.percentile, signed)
    table = colour_table(signed, low, high)
    # Graphics work in single precision: a mesh far from the origin or of extreme size would lose its shape.
    centre, diagonal = points[used].mean(axis=0), np.linalg.norm(np.ptp(points[used], axis=0))
    points = (points - centre) / diagonal

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(*BACKGROUND)
    renderer.SetViewport(0, 0, MESH_PART, 1)
    renderer.AddActor(surface_actor(poly_data(points, triangles, values), table))
    if options.directions:
        directions = np.column_stack([vertices[f"{options.directions}_{axis}"] for axis in "xyz"]).astype(float)
        length = 0.9 * average_edge(points, triangles)
        renderer.AddActor(direction_lines(points[used], directions[used], length))
    renderer.AutomaticLightCreationOff()
    add_lights(renderer)
    place_camera(renderer, points[used], options)
    add_ambient_occlusion(renderer, 1.0)

    margin = vtk.vtkRenderer()
    margin.SetBackground(*BACKGROUND)
    margin.SetViewport(MESH_PART, 0, 1, 1)
    pixels = [SUPERSAMPLING * s for s in options.size]
    margin.AddActor2D(legend(table, pixels))
    margin.AddActor2D(caption(f"{textwrap.fill(name, 18)}\n{unit}", (0.12, 0.83), pixels, 0.0205))
    write_picture(options.picture, pixels, [renderer, margin])


def write_picture(path, pixels, renderers):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*pixels)
    for renderer in renderers:
        window.AddRenderer(renderer)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    smaller = vtk.vtkImageResize()
    smaller.SetInputConnection(grab.GetOutputPort())
    smaller.SetOutputDimensions(pixels[0] // SUPERSAMPLING, pixels[1] // SUPERSAMPLING, 1)
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(smaller.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()
    if writer.GetErrorCode() or not pathlib.Path(path).is_file():
        raise OSError(f"cannot write {path}")


def main(argv):
    try:
        draw(parse_arguments(argv))
    except (OSError, ValueError) as error:
        print(f"render_curvature: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
