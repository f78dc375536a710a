#!/usr/bin/env python3
"""Measures what a rest of the mouse costs: one exact ray through millions of particles.

    PYTHONPATH=build/release/lib/python3/dist-packages python3 benchmarks/window/hover.py [SIDE]

Picks 400 places of a view of SIDE^3 particles (200: 8 millions), from far and from near, through
each of the two structures, and counts where these name different particles. Prints a Markdown table.
"""

import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
import time

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import vtkGenericOpenGLRenderWindow

import mote

size = 1024


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
    renderer = vtkRenderer()
    actor = vtkActor()
    renderer.AddActor(actor)
    window = vtkGenericOpenGLRenderWindow()
    window.SetSize(size, size)
    window.AddRenderer(renderer)
    mappers = {}
    for structure in ("coherent-grid", "pkd-tree"):
        mapper = mappers[structure] = mote.vtkMoteParticleMapper()
        mapper.SetInputData(reader.GetOutput())
        mapper.SetRadiusModeToConstant()
        mapper.SetRadius(0.5)
        mapper.SetStructureName(structure)
        mapper.Update()
    picker = mote.vtkMoteParticlePicker()
    print("| picks of 400 places | median, us | nine of ten within, us | met | differ |\n"
          "|---|---|---|---|---|")
    for name, zoom in (("far", 1.0), ("near", 12.0)):
        found = {}
        for structure, mapper in mappers.items():
            actor.SetMapper(mapper)
            renderer.ResetCamera(mapper.GetBounds())
            camera = renderer.GetActiveCamera()
            camera.SetViewAngle(30.0 / zoom)
            camera.SetPosition(700.0, 350.0, 900.0)
            renderer.ResetCameraClippingRange()
            places, times = random.Random(1), []
            found[structure] = ids = []
            for _ in range(400):
                x, y = places.randrange(size), places.randrange(size)
                begin = time.perf_counter()
                picker.Pick(x, y, 0, renderer)
                times.append(time.perf_counter() - begin)
                ids.append(picker.GetParticleId())
            differ = sum(a != b for a, b in zip(ids, found["coherent-grid"]))
            ninth = sorted(times)[int(0.9 * len(times))]
            print(f"| {name}, {structure} | {1e6 * statistics.median(times):.1f} | "
                  f"{1e6 * ninth:.1f} | {sum(i >= 0 for i in ids)} | {differ} |", flush=True)


if __name__ == "__main__":
    main()
