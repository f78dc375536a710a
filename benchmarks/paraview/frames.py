"""Frames of Mote's representations in ParaView against ParaView's own, as a Markdown table.

    PYTHONPATH=plugins/paraview/tests scripts/paraview batch benchmarks/paraview/frames.py

1024x1024, the camera moves between frames, medians. With a share behind its name, such as 0.01, it
draws so many of the particles and cells: a look at whether it works.
"""

import statistics
import sys
import time

import numpy as np
from checks import numpy_support, picture, points, producer_of, simple, view_of, vtk

random = np.random.default_rng(1)
share = float(sys.argv[1]) if len(sys.argv) > 1 else 1.0


def particles(count):
    """So many at random, and a radius with which they just touch on average."""
    data = points(random.random((count, 3)) * 100.0, v=random.random(count))
    cells = vtk.vtkCellArray()  # Point Gaussian asks for vertices
    ids = np.arange(count + 1, dtype=np.int64)
    cells.SetData(numpy_support.numpy_to_vtkIdTypeArray(ids, deep=True),
                  numpy_support.numpy_to_vtkIdTypeArray(ids[:-1], deep=True))
    data.SetVerts(cells)
    return producer_of(data), 0.5 * 100.0 / count ** (1 / 3)


def hexahedra(n):
    """n^3 of them, whose inner points are moved at random by up to 0.15 of an edge."""
    at = np.linspace(-0.5, 0.5, n + 1)
    places = np.stack(np.meshgrid(at, at, at, indexing="ij"), -1).reshape(-1, 3)
    inside = (np.abs(places) < 0.499).all(1)
    places = places + inside[:, None] * (random.random(places.shape) - 0.5) * 0.3 / n
    ids = np.arange((n + 1) ** 3, dtype=np.int64).reshape(n + 1, n + 1, n + 1)
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells = np.stack([ids[a:n + a, b:n + b, c:n + c].ravel() for a, b, c in corners], -1)
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(points(places).GetPoints())
    array = vtk.vtkCellArray()
    array.SetData(
        numpy_support.numpy_to_vtkIdTypeArray(np.arange(0, 8 * len(cells) + 1, 8), deep=True),
        numpy_support.numpy_to_vtkIdTypeArray(cells.ravel(), deep=True))
    grid.SetCells(vtk.VTK_HEXAHEDRON, array)
    values = np.sin(9 * places[:, 0]) * np.cos(7 * places[:, 1]) + places[:, 2]
    field = numpy_support.numpy_to_vtk(values, deep=True)
    field.SetName("f")
    grid.GetPointData().AddArray(field)
    opacities = simple.GetOpacityTransferFunction("f")
    opacities.Points = [-1.5, 0.0, 0.5, 0.0, 0.0, 0.1, 0.5, 0.0, 1.5, 0.6, 0.5, 0.0]
    simple.GetColorTransferFunction("f").RescaleTransferFunction(-1.5, 1.5)
    return producer_of(grid)


def measure(what, data, kind, group, array, frames=7, **properties):
    view = simple.CreateView("RenderView")
    view.ViewSize = [1024, 1024]
    display = simple.Show(data, view, group)
    simple.ColorBy(display, ("POINTS", array))
    start = time.time()
    display.SetRepresentationType(kind)
    for name, value in properties.items():
        setattr(display, name, value)
    simple.Render(view)
    view.ResetCamera()
    simple.Render(view)
    first, medians = time.time() - start, []
    for view.UseFXAA in (1, 0):  # which smooths the whole picture, and takes its time in each frame
        simple.Render(view)
        gaps = []
        for _ in range(frames):
            view.GetActiveCamera().Azimuth(3)
            start = time.time()
            simple.Render(view)
            gaps.append(time.time() - start)
        medians.append(f"{statistics.median(gaps):.3f}")
    print(f"| {what} | {kind} | {first:.2f} | {' | '.join(medians)} |", flush=True)
    simple.Delete(display)
    simple.Delete(view)


print("| data | representation | first, s | frame, s | without FXAA |\n|---|---|---|---|---|")
for count, theirs in ((8_000_000, "Point Gaussian"), (100_000, "Point Gaussian"), (100_000, "3D Glyphs")):
    count = int(share * count)
    data, radius = particles(count)
    what = f"{count:,} particles"
    for samples in (1, 4):
        measure(f"{what}, rays a pixel {samples}", data, "Mote Particles", "GeometryRepresentation", "v",
                MoteRadiusMode="Constant", MoteRadius=radius, MoteParticleSamples=samples)
    own = {"Point Gaussian": {"GaussianRadius": radius, "ShaderPreset": "Sphere"},
           "3D Glyphs": {"GlyphType": "Sphere", "ScaleFactor": 2 * radius}}[theirs]
    measure(what, data, theirs, "GeometryRepresentation", "v", frames=5, **own)
    simple.Delete(data)
side = round(60 * share ** (1 / 3))
data = hexahedra(side)
for kind in ("Mote Volume", "Volume"):
    measure(f"{side ** 3:,} hexahedra", data, kind, "UnstructuredGridRepresentation", "f", frames=9,
            ScalarOpacityUnitDistance=0.1)

# How far pictures are from one in which every pixel is traced with hardly any tolerance.
view = view_of(size=(1024, 1024), height=1.6)
display = simple.Show(data, view, "UnstructuredGridRepresentation")
simple.ColorBy(display, ("POINTS", "f"))
display.ScalarOpacityUnitDistance = 0.1
view.CameraPosition = [6.0, 5.0, 8.0]
display.SetRepresentationType("Mote Volume")
display.MoteTolerance, display.MoteCloudTolerance = 1e-5, 0.0
exact = picture(view)
display.MoteTolerance, display.MoteCloudTolerance = 0.001, 0.004
for kind in ("Mote Volume", "Volume"):
    display.SetRepresentationType(kind)
    off = np.abs(picture(view) - exact)[exact.sum(axis=2) > 0] / 255
    print(f"{kind}: colours are off by {np.sqrt((off ** 2).mean()):.4f} root mean square, "
          f"{np.quantile(off, 0.999):.4f} for 99.9 %, {off.max():.4f} at most", flush=True)
