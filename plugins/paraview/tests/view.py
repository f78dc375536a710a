"""Mote Render View: light and lines go from one representation to the other."""

import numpy as np
from checks import check, covered, end, picture, points, simple, producer_of, view_of


def show(data, view, **properties):
    display = simple.Show(producer_of(data), view, "GeometryRepresentation")
    display.SetRepresentationType("Mote Particles")
    display.DiffuseColor = [1.0, 1.0, 1.0]
    for name, value in properties.items():
        setattr(display, name, value)
    return display


view = view_of("MoteRenderView")
check(view.GetXMLName() == "MoteRenderView", "there is a Mote render view")
# A ball before the middle of a floor of balls.
floor = [[x, y, -0.6] for x in np.linspace(-1, 1, 21) for y in np.linspace(-1, 1, 21)]
below = show(points(floor, radius=[0.09] * len(floor)), view)
ball = show(points([[0.2, -0.2, 0.0]], radius=[0.25]), view)
plain = picture(view)
check(covered(plain) > 0.9, "both representations are drawn")

view.MoteShadows = 1
view.MoteLightSize = 0.0
lit = picture(view)
view.MoteShadows = 0
check((picture(view) == plain).all(), "without shadows all is as before")
view.MoteShadows = 1
ball.Visibility = 0
alone = picture(view)
ball.Visibility = 1
darker = (lit.sum(axis=2) < 0.6 * alone.sum(axis=2)).mean()
check(darker > 0.02, f"one representation throws a shadow on the other: {darker:.3f} of the view")
view.MoteShadows = 0

view.MoteOcclusion = "Live"
view.MoteOcclusionReach = 1.0
for display in (below, ball):
    display.MoteParticleAmbient = 1.0
    display.Diffuse = 0.0
down, across = np.mgrid[0:300, 0:300]
away = np.hypot(down - 180, across - 180)
ring = (away > 40) & (away < 60)
ball.Position = [0.0, 0.0, -0.25]
near = picture(view)[ring].mean()
ball.Visibility = 0
alone = picture(view)[ring].mean()
ball.Visibility = 1
ball.Position = [0.0, 0.0, 0.0]
check(near < 0.95 * alone, f"around the ball the floor is darker: {near:.0f}, without it {alone:.0f}")
view.MoteOcclusion = "None"
for display in (below, ball):
    display.MoteParticleAmbient = 0.28
    display.Diffuse = 1.0

view.MoteSilhouettes = 1
view.MoteSilhouetteThreshold = 3.0
view.MoteSilhouetteColor = [1.0, 0.0, 0.0]
lines = picture(view)
red = ((lines[:, :, 0] > 150) & (lines[:, :, 1] < 80)).mean()
# Around a circle of radius 1/4 in a view of 2.
length = 2 * np.pi * 0.25 / 2 * 300 * 2 / 300 ** 2
check(0.4 * length < red < 3.0 * length, f"the ball has an outline: {red:.4f}, about {length:.4f}")
view.MoteSilhouettes = 0

# What ParaView draws itself is hidden where it lies behind.
box = simple.Box(XLength=2.0, YLength=2.0, ZLength=0.02, Center=[0.0, 0.0, -0.1])
display = simple.Show(box, view)
display.DiffuseColor = display.AmbientColor = [0.0, 1.0, 0.0]
image = picture(view)
green = (image[:, :, 1] > image[:, :, 0] + 60).mean()
check(abs(green - (1.0 - np.pi * 0.25 ** 2 / 4)) < 0.02, f"depth is common: {green:.3f} is the box")
simple.Delete(box)

simple.SelectSurfacePoints(Rectangle=[170, 110, 190, 130], View=view)
check(ball.Input.GetSelectionInput(0) is not None, "points are selected in this view")
end()
