"""A toy simulation that has its pictures made while it runs: balls that fall into a box.

    scripts/paraview batch plugins/paraview/insitu/simulation.py [STEPS [FOLDER]]

The simulation knows nothing of pictures: it hands its points to ParaView's Catalyst after every
step. What becomes of them is told by pipeline.py, beside this file.
"""

import os
import sys

import numpy as np
from paraview import vtk
from paraview.catalyst import bridge
from paraview.vtk.util import numpy_support

RADIUS = 0.04


class Balls:
    """Balls in a box of 1 x 1 that is open above. They bounce off its walls and off one another."""

    def __init__(self, count, seed=1):
        random = np.random.default_rng(seed)
        self.places = random.random((count, 3)) * (1 - 2 * RADIUS) + RADIUS
        self.places[:, 2] += np.arange(count) * 3.0 / count
        self.velocities = random.normal(0.0, 0.1, (count, 3))

    def contacts(self):
        """Pairs of balls that touch, by cells of a diameter."""
        cells = np.floor(self.places / (2 * RADIUS)).astype(int)
        found = {}
        for i, cell in enumerate(map(tuple, cells)):
            found.setdefault(cell, []).append(i)
        steps = [(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)]
        for (x, y, z), own in found.items():
            for a, b, c in steps:
                for j in found.get((x + a, y + b, z + c), ()):
                    yield from ((i, j) for i in own if i < j)

    def step(self, seconds):
        force = np.zeros_like(self.places)
        force[:, 2] = -9.81
        for i, j in self.contacts():
            apart = self.places[j] - self.places[i]
            distance = np.linalg.norm(apart)
            if 0.0 < distance < 2 * RADIUS:
                normal = apart / distance
                approach = np.dot(self.velocities[j] - self.velocities[i], normal)
                push = 2e4 * (2 * RADIUS - distance) - 20.0 * approach
                force[i] -= push * normal
                force[j] += push * normal
        for axis, most in ((0, 1.0), (1, 1.0), (2, np.inf)):
            for sign, inside in ((1, self.places[:, axis] - RADIUS), (-1, most - RADIUS - self.places[:, axis])):
                force[:, axis] += sign * np.where(inside < 0, -2e4 * inside, 0.0)
                force[:, axis] -= np.where(inside < 0, 20.0 * self.velocities[:, axis], 0.0)
        self.velocities += seconds * force
        self.places += seconds * self.velocities

    def data(self):
        """As VTK has points: places, and arrays of one value a ball."""
        points = vtk.vtkPoints()
        points.SetData(numpy_support.numpy_to_vtk(self.places, deep=True))
        data = vtk.vtkPolyData()
        data.SetPoints(points)
        speed = np.linalg.norm(self.velocities, axis=1)
        for name, values in (("radius", np.full(len(self.places), RADIUS)), ("speed", speed)):
            array = numpy_support.numpy_to_vtk(values, deep=True)
            array.SetName(name)
            data.GetPointData().AddArray(array)
        return data


def main():
    steps = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    if len(sys.argv) > 2:
        os.environ["INSITU_FOLDER"] = sys.argv[2]
    balls = Balls(400)
    bridge.initialize()
    bridge.add_pipeline(os.path.join(os.path.dirname(os.path.abspath(__file__)), "pipeline.py"))
    for step in range(steps + 1):
        bridge.coprocess(step * 1e-3, step, balls.data(), name="input")
        balls.step(1e-3)
    bridge.finalize()


main()
