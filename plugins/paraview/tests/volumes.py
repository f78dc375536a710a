"""Mote Volume and Mote Mesh: opacities, arrays of cells, composite data, surfaces."""

import numpy as np
from checks import check, covered, end, picture, points, simple, producer_of, view_of
from paraview import vtk
from paraview.vtk.util import numpy_support
from paraview.vtk.vtkFiltersSources import vtkCellTypeSource


def block(n, warp=0.0):
    """n^3 hexahedra that fill [-1/2, 1/2]^3, with the arrays z and even of points, k of cells."""
    at = np.linspace(-0.5, 0.5, n + 1)
    x, y, z = np.meshgrid(at, at, at, indexing="ij")
    inside = (np.abs(x) < 0.49) & (np.abs(y) < 0.49) & (np.abs(z) < 0.49)
    x = x + warp * inside * np.sin(9 * y + 5 * z)
    places = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    ids = np.arange((n + 1) ** 3).reshape(n + 1, n + 1, n + 1)
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(points(places).GetPoints())
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    for i in range(n):
        for j in range(n):
            for k in range(n):
                grid.InsertNextCell(vtk.VTK_HEXAHEDRON, 8,
                                    [int(ids[i + a, j + b, k + c]) for a, b, c in corners])
    for name, values, to in (("z", places[:, 2], grid.GetPointData()),
                             ("even", np.ones(len(places)), grid.GetPointData()),
                             ("k", np.arange(n ** 3) % n, grid.GetCellData())):
        array = numpy_support.numpy_to_vtk(values.astype(float), deep=True)
        array.SetName(name)
        to.AddArray(array)
    return grid


def quadratic(n):
    """The same block of n^3 quadratic hexahedra, with the array z."""
    source = vtkCellTypeSource()
    source.SetCellType(vtk.VTK_QUADRATIC_HEXAHEDRON)
    source.SetBlocksDimensions(n, n, n)
    source.Update()
    grid = source.GetOutput()
    places = numpy_support.vtk_to_numpy(grid.GetPoints().GetData()) / n - 0.5
    grid.SetPoints(points(places).GetPoints())
    array = numpy_support.numpy_to_vtk(places[:, 2].astype(float), deep=True)
    array.SetName("z")
    grid.GetPointData().AddArray(array)
    return grid


def show(data, view, array, association="POINTS"):
    display = simple.Show(producer_of(data), view, "UnstructuredGridRepresentation")
    simple.ColorBy(display, (association, array))
    display.SetRepresentationType("Mote Volume")
    return display


def paint(array, low, high, opacity):
    """White, with one opacity for all values."""
    colors, opacities = simple.GetColorTransferFunction(array), simple.GetOpacityTransferFunction(array)
    colors.RGBPoints = [low, 1.0, 1.0, 1.0, high, 1.0, 1.0, 1.0]
    opacities.Points = [low, opacity, 0.5, 0.0, high, opacity, 0.5, 0.0]


view = view_of()
display = show(block(6, 0.02), view, "z")
paint("z", -0.5, 0.5, 0.3)
display.ScalarOpacityUnitDistance = 0.5
image = picture(view)
# A way of 1 through an opacity of 0.3 a half.
expected = 255 * (1 - 0.7 ** 2)
level = image[100:200, 100:200].mean()
check(abs(level - expected) < 1.5, f"an even cloud is as opaque as it should be: {level}, {expected}")
check(abs(covered(image) - 0.25) < 0.01, "and covers the cells")
simple.Delete(display.Input)

display = show(quadratic(3), view, "z")
display.ScalarOpacityUnitDistance = 0.5
check(np.abs(picture(view) - image).max() <= 3, "cells of higher order are as linear ones")
simple.Delete(display.Input)

display = show(block(12, 0.01), view, "z")
paint("z", -0.5, 0.5, 0.3)
display.MoteCloudTolerance = 0.0
every = picture(view)
display.MoteCloudTolerance = 0.004
some = picture(view)
off = np.abs(every - some)
check(np.quantile(off, 0.999) <= 2, f"pixels between are right to a step or two: {off.max()}")
display.MoteCloudTolerance = 0.5
check(np.abs(every - picture(view)).max() > 2, "but for what they may be off by")
simple.Delete(display.Input)

display = show(block(4), view, "k", "CELLS")
paint("k", 0.0, 3.0, 0.3)
display.ScalarOpacityUnitDistance = 0.5
level = picture(view)[100:200, 100:200].mean()
check(abs(level - expected) < 1.5, f"the same by an array of cells: {level}")
opacities = simple.GetOpacityTransferFunction("k")
opacities.Points = [0.0, 0.0, 0.5, 0.0, 3.0, 0.0, 0.5, 0.0]
check(covered(picture(view)) == 0.0, "what the opacity editor makes clear is not seen")
simple.Delete(display.Input)

blocks = vtk.vtkMultiBlockDataSet()
blocks.SetBlock(0, block(3))
display = simple.Show(producer_of(blocks), view)
check("Mote Particles" in display.GetProperty("Representation").Available, "blocks may be drawn by Mote")
simple.Delete(display.Input)

# A surface, against ParaView's own.
sphere = simple.Sphere(Radius=0.5, ThetaResolution=64, PhiResolution=64)
display = simple.Show(sphere, view, "GeometryRepresentation")
display.SetRepresentationType("Surface")
theirs = picture(view)
display.SetRepresentationType("Mote Mesh")
display.MoteMeshSamples = 1
display.MoteMeshAmbient = 0.0
ours = picture(view)
check(abs(covered(theirs) - covered(ours)) < 0.003, "a surface covers what ParaView's covers")
check(np.abs(theirs[120:180, 120:180] - ours[120:180, 120:180]).mean() < 4.0,
      f"and is as bright: {np.abs(theirs - ours).mean()}")
view = view_of()
pump = simple.PumpMote(Scale=0.002)
scales = []
for kind in ("Surface", "Mote Volume"):
    display = simple.Show(pump, view)
    display.SetRepresentationType(kind)
    simple.ResetCamera(view)
    scales.append(view.CameraParallelScale)
    simple.Delete(view)
    view = view_of()
check(abs(scales[1] / scales[0] - 1.0) < 1e-3, f"the first view is of the data: {scales}")
end()
