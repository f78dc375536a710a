"""Mote Particles: spheres, radii, colours, ranges, selection, blocks and readers."""

import os

import numpy as np
from checks import check, covered, end, picture, points, simple, producer_of, view_of
from paraview import servermanager, vtk


def show(data, view, **properties):
    display = simple.Show(producer_of(data), view, "GeometryRepresentation")
    display.SetRepresentationType("Mote Particles")
    for name, value in properties.items():
        setattr(display, name, value)
    return display


# One sphere of radius 1/2 in a view of 2 x 2 covers a circle.
view = view_of()
display = show(points([[0, 0, 0]], radius=[0.5]), view, MoteParticleSamples=16)
circle = np.pi * 0.25 / 4
check(abs(covered(picture(view)) - circle) < 0.01, "a sphere covers a circle of its radius")
display.MoteRadiusScale = 1.5
check(abs(covered(picture(view)) - 2.25 * circle) < 0.01, "the radius scale counts")
display.MoteRadiusScale = 1.0
display.MoteRadiusMode = "Constant"
display.MoteRadius = 0.25
check(abs(covered(picture(view)) - 0.25 * circle) < 0.01, "a constant radius counts")
simple.Delete(display.Input)

# Four particles, coloured by an array through ParaView's own colour map.
places = [[-0.5, 0.5, 0], [0.5, 0.5, 0], [-0.5, -0.5, 0], [0.5, -0.5, 0]]
values = [0.0, 1.0, 2.0, 3.0]
display = show(points(places, radius=[0.3] * 4, speed=values, size=[0.1, 0.2, 0.3, 0.4]), view,
               Ambient=0.0)
simple.ColorBy(display, ("POINTS", "speed"))
colors = simple.GetColorTransferFunction("speed")
colors.RGBPoints = [0.0, 1.0, 0.0, 0.0, 3.0, 0.0, 0.0, 1.0]
colors.ColorSpace = "RGB"
image = picture(view)
reds = [image[75, 75, 0], image[75, 225, 0], image[225, 75, 0], image[225, 225, 0]]
blues = [image[75, 75, 2], image[75, 225, 2], image[225, 75, 2], image[225, 225, 2]]
check(reds == sorted(reds, reverse=True) and reds[0] > 150 and reds[3] < 10,
      f"colours are those of the colour map: red {reds}")
check(blues == sorted(blues) and blues[3] > 150 and blues[0] < 10, f"and blue {blues}")

# A range hides, and does not only recolour.
display.MoteUseRange = 1
display.MoteRangeArray = ["POINTS", "size"]
display.MoteRange = [0.15, 0.35]
image = picture(view)
seen = [bool(image[y, x].sum() > 0) for y, x in ((75, 75), (75, 225), (225, 75), (225, 225))]
check(seen == [False, True, True, False], f"a range of another array hides: {seen}")
display.MoteUseRange = 0

# Radii of an array of another name.
display.MoteRadiusMode = "By Array"
display.MoteRadiusArray = ["POINTS", "size"]
expected = np.pi * sum(r * r for r in (0.1, 0.2, 0.3, 0.4)) / 4
check(abs(covered(picture(view)) - expected) < 0.01, "radii are those of the array")
display.MoteRadiusMode = "Automatic"

# Selection names the points.
picture(view)
simple.SelectSurfacePoints(Rectangle=[160, 160, 290, 290], View=view)
selection = simple.GetActiveSource()
ids = servermanager.Fetch(simple.ExtractSelection(
    Input=display.Input)) if display.Input.GetSelectionInput(0) else None
found = sorted(ids.GetPointData().GetArray("speed").GetValue(i)
               for i in range(ids.GetNumberOfPoints())) if ids else None
check(found == [1.0], f"what is selected in the upper right corner is the second particle: {found}")
simple.Delete(display.Input)

# Points in blocks, of which one is empty.
blocks = vtk.vtkMultiBlockDataSet()
blocks.SetBlock(0, points(places[:1], radius=[0.3]))
blocks.SetBlock(1, vtk.vtkPolyData())
blocks.SetBlock(2, points(places[1:], radius=[0.3] * 3))
display = show(blocks, view, MoteParticleSamples=16)
check(abs(covered(picture(view)) - np.pi * 0.09) < 0.015, "particles of all blocks are drawn")
simple.Delete(display.Input)

# A dump opens as Mote's particles, with its steps.
dump = simple.OpenDataFile(os.path.join(os.environ["MOTE_DATA"], "copper-scratch.dump.gz"))
display = simple.Show(dump, view)
check(display.Representation == "Mote Particles", "dumps are shown as Mote's particles")
check(len(dump.TimestepValues) == 7, f"a dump has its steps: {len(dump.TimestepValues)}")
view.ResetCamera()
first = picture(view)
view.ViewTime = dump.TimestepValues[-1]
last = picture(view)
check(covered(first) > 0.1, "a dump is drawn")
check((first != last).any(), "another step is another picture")
end()
