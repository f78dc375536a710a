#!/usr/bin/env python3
"""Measures what a rest of the mouse costs: one exact ray through millions of particles.

    PYTHONPATH=build/release/lib/python3/dist-packages python3 benchmarks/window/hover.py [SIDE]

Picks 400 places of a view of SIDE^3 particles (200: 8 millions), from far and from near, and looks
for the nearest of all spheres by brute force at 20 of them. Needs NumPy. Prints a Markdown table.
"""

import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import vtkGenericOpenGLRenderWindow

import mote

size = 1024


def ray_of(renderer, x, y):
    """Begin and direction of the ray through the middle of a pixel."""
    ends = []
    for depth in (0.0, 1.0):
        renderer.SetDisplayPoint(x, y, depth)
        renderer.DisplayToWorld()
        point = numpy.array(renderer.GetWorldPoint())
        ends.append(point[:3] / point[3])
    way = ends[1] - ends[0]
    return ends[0], way / numpy.linalg.norm(way)


def nearest(points, radius, origin, way):
    """The sphere that a ray meets first, by brute force; -1: none."""
    along = (points - origin) @ way
    rest = radius**2 - (((points - origin) - along[:, None] * way) ** 2).sum(axis=1)
    at = numpy.where(rest >= 0.0, along - numpy.sqrt(numpy.maximum(rest, 0.0)), numpy.inf)
    at[at < 0.0] = numpy.inf
    return int(at.argmin()) if numpy.isfinite(at.min()) else -1


def main():
    side = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    here = pathlib.Path(__file__).resolve().parent
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "many.vtp"
        subprocess.run([sys.executable, here / "../../tests/app/many_particles.py", file,
                        str(side)], check=True)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(file))
        reader.Update()
    mapper = mote.vtkMoteParticleMapper()
    mapper.SetInputData(reader.GetOutput())
    mapper.SetRadius(0.5)
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    window = vtkGenericOpenGLRenderWindow()
    window.SetSize(size, size)
    window.AddRenderer(renderer)
    mapper.Update()
    points = vtk_to_numpy(reader.GetOutput().GetPoints().GetData()).astype(float)
    picker = mote.vtkMoteParticlePicker()
    random = numpy.random.default_rng(1)
    print("| picks of 400 places | median, ms | nine of ten within, ms | met | wrong of 20 |\n"
          "|---|---|---|---|---|")
    for name, zoom in (("far", 1.0), ("near", 12.0)):
        renderer.ResetCamera()
        renderer.GetActiveCamera().Azimuth(31.0)
        renderer.GetActiveCamera().Elevation(17.0)
        renderer.GetActiveCamera().Zoom(zoom)
        renderer.ResetCameraClippingRange()
        times, met, wrong = [], 0, 0
        for k in range(400):
            x, y = random.integers(0, size, 2)
            begin = time.perf_counter()
            found = picker.Pick(x, y, 0, renderer)
            times.append(time.perf_counter() - begin)
            met += found
            if k % 20 == 0:
                truth = nearest(points, 0.5, *ray_of(renderer, x + 0.5, y + 0.5))
                wrong += truth != picker.GetParticleId()
        ninth = sorted(times)[int(0.9 * len(times))]
        print(f"| {name} | {1000 * statistics.median(times):.2f} | {1000 * ninth:.2f} | {met} |"
              f" {wrong} |", flush=True)


if __name__ == "__main__":
    main()
