"""A client and a server: what is drawn there, and what is brought here and drawn here, is the same.

remote.py PORT: the server listens there."""

import os
import sys

import numpy as np
from checks import check, covered, end, picture, simple, view_of

connection = simple.Connect("localhost", int(sys.argv[1]))
check(connection is not None, "there is a server")
simple.LoadPlugin(os.environ["MOTE_PLUGIN"], remote=True, ns=vars(simple))
simple.LoadPlugin(os.environ["MOTE_PLUGIN"], remote=False, ns=vars(simple))
data = os.environ["MOTE_DATA"]


def both(view, words):
    """Pictures of the server and of the client."""
    view.RemoteRenderThreshold = 0
    there = picture(view)
    view.RemoteRenderThreshold = 1e6
    here = picture(view)
    off = np.abs(there - here).max(axis=2)
    check(covered(there) > 0.05, f"{words}: the server draws {covered(there):.3f} of the view")
    check(off.max() == 0, f"{words}: the client draws the same; off by {off.max()} of 255")
    return there


dump = simple.OpenDataFile(os.path.join(data, "copper-scratch.dump.gz"))
for kind in ("RenderView", "MoteRenderView"):
    view = view_of(kind)
    display = simple.Show(dump, view)
    check(display.Representation == "Mote Particles", "a dump is shown as Mote Particles")
    display.MoteParticleSamples = 1
    simple.ColorBy(display, ("POINTS", "c_centro"))
    simple.ResetCamera(view)
    plain = both(view, f"particles in a {kind}")
    display.MoteRadiusScale = 0.5
    smaller = both(view, "half the radius")
    check(covered(smaller) < 0.97 * covered(plain), "properties reach both")
    display.MoteRadiusScale = 1.0
    if kind == "MoteRenderView":
        view.MoteShadows = 1
        shaded = both(view, "with shadows")
        check((np.abs(shaded - plain).max(axis=2) > 30).mean() > 0.01, "shadows are seen")
        view.MoteShadows = 0
    simple.SelectSurfacePoints(Rectangle=[100, 100, 200, 200], View=view)
    check(dump.GetSelectionInput(0) is not None, "points are selected on the screen")
    simple.ClearSelection(dump)
    simple.Delete(view)

view = view_of("RenderView")
pump = simple.PumpMote(Scale=0.002)
display = simple.Show(pump, view)
display.SetRepresentationType("Mote Volume")
simple.ColorBy(display, ("POINTS", "pressure"))
low, high = pump.PointData["pressure"].GetRange()
simple.GetOpacityTransferFunction("pressure").Points = [low, 0.3, 0.5, 0.0, high, 0.3, 0.5, 0.0]
simple.ResetCamera(view)
both(view, "a volume")
end()
